// SPDX-License-Identifier: Apache-2.0
#include "cli/moving_scene.h"

#include <fmt/format.h>

#include <system_error>

#include "cli/render_scene.h"
#include "core/error.h"
#include "io/picture/known_pictures.h"

namespace twinray {
namespace {

FileState state_of(const std::string& path) {
  std::error_code no_time, no_size;
  const auto written = std::filesystem::last_write_time(path, no_time);
  const std::uintmax_t bytes = std::filesystem::file_size(path, no_size);
  return {path, no_time ? std::nullopt : std::optional(written), no_size ? 0 : bytes};
}

}  // namespace

MovingScene::MovingScene(const RenderArguments& arguments, const LoadedScene& first)
    : arguments_(arguments), first_(first) {
  arguments_.load.known = std::make_shared<KnownPictures>();
  if (arguments.load.files)
    for (const std::string& path : *arguments.load.files) files_.push_back(state_of(path));
}

Motion MovingScene::motion() {
  return {arguments_.samples_per_moment, [this](double part) { return at(part); }};
}

namespace {

double part_of(std::uint32_t sample, const RenderArguments& arguments) {
  return shutter_part(sample / arguments.samples_per_moment, arguments.render.seed);
}

}  // namespace

double MovingScene::time_of(std::uint32_t sample) const {
  return arguments_.shutter->at(part_of(sample, arguments_));
}

TracedScene MovingScene::of_sample(std::uint32_t sample) { return at(part_of(sample, arguments_)); }

TracedScene MovingScene::at(double part) {
  // What the last one has taken is free before the next one needs it.
  integrator_.reset();
  accelerator_.reset();
  loaded_.reset();
  const double time = arguments_.shutter->at(part);
  try {
    for (const FileState& file : files_)
      if (state_of(file.path) != file) throw Error(file.path + ": it was changed after the render had begun");
    loaded_.emplace(load_for_moment(arguments_, first_, time));
    accelerator_ = build_accelerator(arguments_.backend, loaded_->scene.geometry, arguments_.build);
    integrator_ = make_integrator(arguments_, loaded_->scene);
  } catch (const Error& error) {
    throw Error(fmt::format("at {:g} s: {}", time, error.what()));
  }
  return {loaded_->scene, *accelerator_, *integrator_};
}

}  // namespace twinray
