// SPDX-License-Identifier: Apache-2.0
#include "bench/workload.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/asking.h"

namespace twinray::bench {
namespace {

/// The rays of each set that brute force is asked for; fewer where a scene has so many primitives.
constexpr std::size_t most_proved = 16;
constexpr double proof_tests = 1e8;
constexpr double native_difference_limit = 1e-3;
/// Embree takes rays into an instance by a float matrix: those that start on it find it again more often.
constexpr double instanced_difference_limit = 5e-3;
/// Relative difference of t up to which Embree's own answer counts as the same hit.
constexpr float native_t_tolerance = 1e-3f;
/// Fewer rays than this may not stand for a set: a rate of one in a thousand would have no meaning.
constexpr double least_allowed = 3;

bool is_close(const Hit& a, const Hit& b) {
  if (a.is_miss() || b.is_miss()) return a.is_miss() == b.is_miss();
  return std::fabs(a.t - b.t) <= native_t_tolerance * std::fabs(b.t);
}

/// Every how many-th ray brute force is asked for.
std::size_t proof_step(std::size_t rays, std::size_t primitives) {
  const double affordable = proof_tests / double(std::max<std::size_t>(1, primitives)) / ray_sets.size();
  const std::size_t proved = std::clamp<std::size_t>(std::size_t(affordable), 1, most_proved);
  return rays / proved + 1;
}

}  // namespace

std::vector<Ray> every(std::size_t step, const std::vector<Ray>& rays) {
  std::vector<Ray> some;
  for (std::size_t i = 0; i < rays.size(); i += step) some.push_back(rays[i]);
  return some;
}

Workload::Workload(const SceneSource& source, int width, int height)
    : source_(source), scene_(source.make()) {
  const auto recorded = record_rays(scene_, {.width = width, .height = height, .max_depth = 3});
  for (std::size_t set = 0; set < ray_sets.size(); ++set)
    rays_[set] = rays_of_kind(recorded, ray_sets[set].kind, ray_sets[set].vertex);
}

std::unique_ptr<Accelerator> Workload::build(const Engine& engine, int threads) const {
  BuildOptions options = engine.build;
  options.threads = threads;
  return build_accelerator(engine.backend, scene_.geometry, options);
}

void Workload::expect() {
  is_expected_ = true;
  const auto bvh = build_accelerator(Backend::bvh, scene_.geometry, {.bvh_width = 2});
  const auto oracle = build_accelerator(Backend::brute_force, scene_.geometry);
  for (std::size_t set = 0; set < ray_sets.size(); ++set) {
    const RayKind kind = ray_sets[set].kind;
    const Engine singly{};
    expected_[set] = answers_of(singly, *bvh, kind, rays_[set]);
    const std::size_t step = proof_step(rays_[set].size(), primitives());
    const std::vector<Hit> proved = answers_of(singly, *oracle, kind, every(step, rays_[set]));
    for (std::size_t i = 0; i < proved.size(); ++i)
      if (!(proved[i] == expected_[set][i * step]))
        oracle_complaint_ = fmt::format("brute force differs on ray {} of {}", i * step, ray_sets[set].name);
  }
}

std::string Workload::check(const Engine& engine, const Accelerator& accelerator) {
  if (!is_expected_) expect();
  if (!oracle_complaint_.empty()) return oracle_complaint_;
  for (std::size_t set = 0; set < ray_sets.size(); ++set) {
    const std::vector<Ray>& rays = rays_[set];
    const std::size_t step =
        engine.backend == Backend::brute_force ? proof_step(rays.size(), primitives()) : 1;
    const std::vector<Hit> found = answers_of(engine, accelerator, ray_sets[set].kind, every(step, rays));
    std::size_t different = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
      const Hit& expected = expected_[set][i * step];
      different += engine.is_canonical() ? !(found[i] == expected) : !is_close(found[i], expected);
    }
    const double allowed =
        scene_.geometry->has_instances() ? instanced_difference_limit : native_difference_limit;
    const double limit = engine.is_canonical() ? 0 : std::max(least_allowed, allowed * double(rays.size()));
    if (double(different) > limit)
      return fmt::format("{} of {} answers to {} rays are wrong", different, rays.size(), ray_sets[set].name);
  }
  return "";
}

}  // namespace twinray::bench
