// SPDX-License-Identifier: Apache-2.0
#include "integrators/walk_below.h"

#include <algorithm>

#include "core/frame.h"
#include "core/spawn_ray.h"
#include "core/surface.h"
#include "core/surface_model.h"
#include "integrators/interaction.h"

namespace twinray {
namespace {

/// From this step on a walk may be given up: few are so long where much is absorbed.
constexpr std::uint32_t first_roulette = 16;

/// False where the walk is given up.
bool survives(const VertexSampler& draws, Rgb& left) {
  const float probability = std::min(max_component(left), 1.0f);
  if (draws.draw_1d(Purpose::roulette) >= probability) return false;
  left = left / probability;
  return true;
}

/// Goes through a surface within the body.
void pass(const Scene& scene, const SurfacePoint& point, WalkEnd& walk) {
  const Vec3 back = -walk.ray.direction;
  const Material& material = scene.materials[material_at(scene, point)];
  if (lets_light_in(material)) {
    const float ior = ior_of(material.model);
    const float eta = side_of(point, back) == Side::outside ? ior : 1 / ior;
    walk.eta_squared *= eta * eta;
    walk.left = walk.left / (eta * eta);
  }
  walk.interiors = Interaction::interiors_behind(scene, point, back, walk.interiors);
  walk.ray = spawn_ray(point, walk.ray.direction);
}

}  // namespace

WalkBelow::WalkBelow(const Scene& scene, const BodyBelow& body, const WalkStart& start, const Rgb& throughput,
                     const WalkDraws& draws)
    : scene_(&scene),
      body_(body),
      start_(start),
      throughput_(throughput),
      draws_(draws),
      phase_(body.medium.anisotropy),
      walk_{.ray = start.into, .left = {1, 1, 1}, .interiors = start.interiors},
      before_(start.way) {
  take_off();
}

void WalkBelow::take_off() {
  flight_.emplace(throughput_ * walk_.left, draws_.at(step_).draw_1d(Purpose::medium));
  ray_ = walk_.ray;
  if (step_ == 0 && start_.left_if_open) return;  // Whether anything is hit matters at any distance.
  ray_.t_max = t_beyond(ray_, std::max(flight_->reach(body_.medium) - before_, 0.0f));
}

bool WalkBelow::goes_on(const Hit& hit) {
  const VertexSampler sampler = draws_.at(step_);
  walk_.hit = hit;
  if (step_ == 0 && hit.is_miss() && start_.left_if_open) {
    walk_.left = *start_.left_if_open;
    return comes_out();
  }
  // The medium is even, so it is the same wherever the way begins.
  const Ray whole{.direction = walk_.ray.direction};
  const bool is_scattered =
      flight_->ends_within(body_.medium, MediumColumn(*scene_, body_.medium, whole, before_ + hit.t));
  walk_.left = walk_.left * flight_->weight();
  if (is_black(throughput_ * walk_.left)) return false;
  if (is_scattered) {
    scatter(std::max(flight_->distance() - before_, 0.0f), sampler.draw_2d(Purpose::direction));
  } else {
    if (hit.is_miss()) return false;
    const SurfacePoint point = surface_at(*scene_->geometry, hit);
    if (scene_->bindings[point.shape].material == body_.material) return comes_out();
    pass(*scene_, point, walk_);
  }
  before_ = 0;
  if (step_ >= first_roulette && !survives(sampler, walk_.left)) return false;
  if (++step_ == WalkDraws::most_steps) return comes_back();
  take_off();
  return true;
}

void WalkBelow::scatter(float distance, Vec2 u) {
  ++walk_.events;
  const Ray before = walk_.ray;
  walk_.ray = {.origin = before.origin + before.direction * distance,
               .direction = Frame(-before.direction).to_world(phase_.sample(u))};
}

bool WalkBelow::comes_out() {
  end_ = walk_;
  return false;
}

bool WalkBelow::comes_back() {
  walk_.hit = Hit{};
  walk_.interiors = start_.interiors;
  walk_.left = walk_.left * walk_.eta_squared;
  walk_.eta_squared = 1;
  return comes_out();
}

std::optional<WalkEnd> walk_below(Tracer& tracer, WalkBelow walk) {
  while (walk.goes_on(tracer.bounce_hit(walk.ray()))) continue;
  return walk.end();
}

}  // namespace twinray
