// SPDX-License-Identifier: Apache-2.0
#include "cli/render_command_line.h"

#include <memory>

#include "cli/no_effect.h"
#include "cli/options/render.h"
#include "cli/shutter.h"

namespace twinray {
namespace {

void add_options(CLI::App& app, RenderRequest& request) {
  add_scene(app, request.arguments.scene);
  add_picture_options(app, request);
  add_display_options(app, request);
  add_layer_options(app, request);
  add_light_options(app, request);
  add_texture_options(app, request);
  add_sampling_options(app, request);
  add_denoise_options(app, request);
  add_engine_options(app, request);
  add_film_options(app, request);
  add_replay_options(app, request);
  add_run_options(app, request);
}

std::function<RenderWords()> add_render_words(CLI::App& app) {
  const auto request = std::make_shared<RenderRequest>();
  add_options(app, *request);
  return [request, &app] {
    RenderWords words = given_words(app);
    for (const std::string& name : given_defaults(app)) words.erase(name);
    return words;
  };
}

}  // namespace

RenderArguments resolved_render(const RenderRequest& request, const Words& given) {
  RenderArguments arguments = request.arguments;
  arguments.given = given;
  resolve_picture(arguments);
  resolve_display(arguments);
  resolve_light(request, arguments);
  resolve_sampling(request, arguments);
  resolve_engine(request, arguments);
  check_shutter(arguments);
  resolve_replay(request, arguments);
  resolve_layers(request, arguments);
  resolve_overscan(arguments);
  resolve_denoising(request, arguments);
  resolve_film(request, arguments);
  resolve_run(request, arguments);
  arguments.without_effect = options_without_effect(request, arguments);
  refuse_if_strict(arguments.without_effect, arguments);
  return arguments;
}

void take_defaults(const RenderDefaults& defaults, RenderArguments& arguments) {
  if (is_cs184(arguments)) return;
  take_frame(defaults, arguments);
  const bool has_samples = is_given("--samples", arguments) || is_given("--of", arguments);
  if (defaults.samples && !has_samples && !is_open_ended(arguments.render))
    arguments.render.samples = *defaults.samples;
  if (defaults.max_depth && !is_given("--max-depth", arguments)) take_depth(*defaults.max_depth, arguments);
  arguments.display.daylight_kelvin = defaults.daylight_kelvin;
}

std::function<RenderArguments()> add_render_options(CLI::App& app) {
  const auto request = std::make_shared<RenderRequest>();
  add_options(app, *request);
  return [request, &app] {
    RenderArguments arguments = resolved_render(*request, given_options(app));
    arguments.given_words = given_words(app);
    arguments.given_defaults = given_defaults(app);
    return arguments;
  };
}

void refuse_if_strict(const std::vector<std::string>& without_effect, const RenderArguments& arguments) {
  if (arguments.load.strict && !without_effect.empty()) throw UsageError(without_effect.front());
}

RenderWords parse_render_words(const Words& words) {
  return parse_alone<RenderWords>(add_render_words, words);
}

RenderArguments parse_render_arguments(const std::vector<std::string>& words) {
  return parse_alone<RenderArguments>(add_render_options, words);
}

}  // namespace twinray
