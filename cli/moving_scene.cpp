// SPDX-License-Identifier: Apache-2.0
#include "cli/moving_scene.h"

#include "cli/render_scene.h"
#include "io/picture/known_pictures.h"

namespace twinray {
MovingScene::MovingScene(const RenderArguments& arguments, const LoadedScene& first)
    : arguments_(arguments), first_(first) {
  arguments_.load.known = std::make_shared<KnownPictures>();
}

Motion MovingScene::motion() {
  return {arguments_.samples_per_moment, [this](double part) { return at(part); }};
}

TracedScene MovingScene::of_sample(std::uint32_t sample) {
  return at(shutter_part(motion().moment_of(sample), arguments_.render.seed));
}

TracedScene MovingScene::at(double part) {
  // What the last one has taken is free before the next one needs it.
  integrator_.reset();
  accelerator_.reset();
  loaded_.reset();
  loaded_.emplace(load_for_moment(arguments_, first_, arguments_.shutter->at(part)));
  accelerator_ = build_accelerator(arguments_.backend, loaded_->scene.geometry, arguments_.build);
  integrator_ = make_integrator(arguments_, loaded_->scene);
  return {loaded_->scene, *accelerator_, *integrator_};
}

}  // namespace twinray
