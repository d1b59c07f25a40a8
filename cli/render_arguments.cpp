// SPDX-License-Identifier: Apache-2.0
#include "cli/render_arguments.h"

#include <memory>

#include "cli/render_options.h"

namespace twinray {
namespace {

void add_options(CLI::App& app, RenderRequest& request) {
  add_scene(app, request.arguments.scene);
  add_picture_options(app, request);
  add_light_options(app, request);
  add_sampling_options(app, request);
  add_engine_options(app, request);
  add_run_options(app, request);
}

RenderArguments resolved(const RenderRequest& request) {
  RenderArguments arguments = request.arguments;
  resolve_picture(request, arguments);
  resolve_light(request, arguments);
  resolve_sampling(request, arguments);
  resolve_engine(request, arguments);
  return arguments;
}

}  // namespace

std::function<RenderArguments()> add_render_options(CLI::App& app) {
  const auto request = std::make_shared<RenderRequest>();
  add_options(app, *request);
  return [request] { return resolved(*request); };
}

RenderArguments parse_render_arguments(const std::vector<std::string>& words) {
  return parse_alone<RenderArguments>(add_render_options, words);
}

}  // namespace twinray
