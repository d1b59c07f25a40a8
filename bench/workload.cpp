// SPDX-License-Identifier: Apache-2.0
#include "bench/workload.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <utility>

#include "io/scene_file.h"

namespace twinray::bench {
namespace {

constexpr std::size_t brute_force_rays = 64;
constexpr double native_difference_limit = 1e-3;
/// Relative difference of t up to which embree-native's answer counts as the same hit.
constexpr float native_t_tolerance = 1e-3f;

Hit answer(const Accelerator& accelerator, const RecordedRay& entry) {
  if (entry.kind != RayKind::shadow) return accelerator.closest_hit(entry.ray);
  Hit hit;
  if (accelerator.any_hit(entry.ray)) hit.t = 0;
  return hit;
}

bool is_close(const Hit& a, const Hit& b) {
  if (a.is_miss() || b.is_miss()) return a.is_miss() == b.is_miss();
  return std::fabs(a.t - b.t) <= native_t_tolerance * std::fabs(b.t);
}

}  // namespace

std::vector<Engine> engines() {
  std::vector<Engine> all;
  for (const Backend backend : available_backends())
    if (backend != Backend::brute_force) all.push_back({backend_name(backend), backend, {}});
  all.push_back({"bvh-2", Backend::bvh, {.bvh_width = 2}});
  for (const auto& [name, split] : {std::pair{"bvh-median", BvhSplit::median},
                                    {"bvh-midpoint", BvhSplit::midpoint},
                                    {"bvh-mean", BvhSplit::mean}}) {
    BuildOptions options;
    options.bvh_width = 2;
    options.bvh_split = split;
    all.push_back({name, Backend::bvh, options});
  }
  all.push_back({"brute-force", Backend::brute_force, {}});
  return all;
}

const Scene& Workload::scene() {
  if (!scene_) {
    scene_ = std::make_unique<Scene>(load_scene(path_, {}).scene);
    scene_->camera = view_whole(fit_frame(scene_->camera, 4, 3), scene_->geometry->bounds());
  }
  return *scene_;
}

const std::vector<RecordedRay>& Workload::recorded() {
  if (recorded_.empty()) recorded_ = record_rays(scene());
  return recorded_;
}

std::unique_ptr<Accelerator> Workload::build(const Engine& engine) {
  return build_accelerator(engine.backend, scene().geometry, engine.options);
}

std::string Workload::check(const Engine& engine, const Accelerator& accelerator) {
  if (expected_.empty()) {
    const auto bvh = build_accelerator(Backend::bvh, scene().geometry);
    for (const RecordedRay& entry : recorded()) expected_.push_back(answer(*bvh, entry));
    const auto oracle = build_accelerator(Backend::brute_force, scene().geometry);
    const std::size_t step = recorded().size() / brute_force_rays + 1;
    for (std::size_t i = 0; i < recorded().size(); i += step)
      if (!(answer(*oracle, recorded()[i]) == expected_[i]))
        return fmt::format("brute force differs on ray {}", i);
  }
  std::size_t different = 0;
  const bool is_canonical = engine.backend != Backend::embree_native;
  const std::size_t step =
      engine.backend == Backend::brute_force ? recorded().size() / brute_force_rays + 1 : 1;
  for (std::size_t i = 0; i < recorded().size(); i += step) {
    const Hit found = answer(accelerator, recorded()[i]);
    different += is_canonical ? !(found == expected_[i]) : !is_close(found, expected_[i]);
  }
  const double limit = is_canonical ? 0 : native_difference_limit * double(recorded().size());
  return double(different) > limit ? fmt::format("{} of {} answers are wrong", different, recorded().size())
                                   : "";
}

std::vector<std::shared_ptr<Workload>> workloads(const std::string& own_scenes, const std::string& folder) {
  std::vector<std::shared_ptr<Workload>> all;
  all.push_back(std::make_shared<Workload>("box", own_scenes + "/cornell-bunny.dae"));
  all.push_back(std::make_shared<Workload>("spheres", own_scenes + "/spheres.dae"));
  for (const auto& [name, path] : {std::pair{"cow", "cs184/meshedit/cow.dae"},
                                   {"CBbunny", "cs184/sky/CBbunny.dae"},
                                   {"CBlucy", "cs184/sky/CBlucy.dae"},
                                   {"CBdragon", "cs184/sky/CBdragon.dae"}})
    if (!folder.empty() && std::filesystem::exists(folder + "/" + path))
      all.push_back(std::make_shared<Workload>(name, folder + "/" + path));
  return all;
}

}  // namespace twinray::bench
