// SPDX-License-Identifier: Apache-2.0
#include "check/scene_crosscheck.h"

#include <algorithm>
#include <chrono>
#include <mutex>

#include "check/placement.h"
#include "check/recorded_rays.h"
#include "check/shape_rays.h"
#include "core/error.h"
#include "core/parallel.h"

namespace twinray {
namespace {

constexpr std::size_t batch_size = 4096;
constexpr std::uint64_t brute_force_rays = 10000;
/// Of 100 rays, how many are of light paths, how many random, and how many of a scene that was moved: there
/// no tree is of much use, since all boxes are widened by more than their size. 5 for each other class.
constexpr std::uint64_t path_share = 34, random_share = 10, moved_share = 1, other_share = 5;

std::uint64_t share_of(RayClass ray_class) {
  if (ray_class == RayClass::random) return random_share;
  return ray_class == RayClass::moved ? moved_share : other_share;
}

/// The engines with a reference first.
std::vector<Engine> ordered(const CrosscheckOptions& options) {
  std::vector<Engine> engines;
  for (const std::string& name : options.engines) engines.push_back(named_engine(name, options.build));
  const auto reference = std::find_if(engines.begin(), engines.end(), can_be_reference);
  if (engines.size() < 2 || reference == engines.end())
    throw Error("a crosscheck needs two engines, one of them bvh, bvh-2 or embree");
  std::rotate(engines.begin(), reference, reference + 1);
  return engines;
}

/// All engines, built over one placement of a geometry.
class LineUp {
 public:
  /// Brute force is asked for some of `rays` only.
  LineUp(std::shared_ptr<const Geometry> geometry, const std::vector<Engine>& engines, std::uint64_t rays)
      : geometry_(std::move(geometry)), crosscheck_(geometry_, build(engines, rays)) {}

  const Crosscheck& crosscheck() const { return crosscheck_; }
  const Accelerator& reference() const { return *owned_.front(); }
  const std::shared_ptr<const Geometry>& geometry() const { return geometry_; }

 private:
  std::vector<CheckedEngine> build(const std::vector<Engine>& engines, std::uint64_t rays) {
    std::vector<CheckedEngine> checked;
    for (const Engine& engine : engines) {
      owned_.push_back(build_accelerator(engine.backend, geometry_, engine.build));
      const std::uint64_t every =
          engine.backend == Backend::brute_force ? (rays - 1) / brute_force_rays + 1 : 1;
      checked.push_back({engine.name, owned_.back().get(), engine.is_canonical(), every});
    }
    return checked;
  }

  std::shared_ptr<const Geometry> geometry_;
  std::vector<std::unique_ptr<Accelerator>> owned_;
  Crosscheck crosscheck_;
};

/// One crosscheck in progress.
class Run {
 public:
  Run(const Scene& scene, const CrosscheckOptions& options,
      const std::function<void(std::uint64_t)>& progress)
      : scene_(scene),
        options_(options),
        engines_(ordered(options)),
        progress_(progress),
        report_(engines_.size(), options.kept) {}

  SceneCrosscheck run() {
    const auto start = std::chrono::steady_clock::now();
    for (const Placement placement : {Placement::file, Placement::moved, Placement::shrunk, Placement::grown})
      check(placement);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    std::vector<std::string> names;
    for (const Engine& engine : engines_) names.push_back(engine.name);
    return {std::move(names), std::move(report_), seconds.count()};
  }

 private:
  void check(Placement placement) {
    const LineUp line_up(placed_geometry(scene_.geometry, placement), engines_, options_.rays);
    if (placement == Placement::file) check_paths(line_up);
    const ShapeRays rays(line_up.geometry(), line_up.reference(), options_.seed);
    for (std::size_t i = std::size_t(RayClass::random); i < ray_class_count; ++i)
      if (placement_of(RayClass(i)) == placement) check_shape_rays(line_up, rays, RayClass(i));
    report_.judge(*line_up.geometry(), placement);
  }

  void check_paths(const LineUp& line_up) {
    const PathRays paths(scene_, line_up.reference(), options_.seed);
    in_batches(share(path_share), [&](std::uint64_t first, std::size_t count, CrosscheckReport& report) {
      const std::vector<RecordedRay> rays = paths.batch(first / batch_size, count);
      for (std::size_t i = 0; i < count; ++i)
        line_up.crosscheck().check(rays[i].ray, class_of(rays[i].kind), first + i, report);
    });
  }

  void check_shape_rays(const LineUp& line_up, const ShapeRays& rays, RayClass ray_class) {
    in_batches(share(share_of(ray_class)),
               [&](std::uint64_t first, std::size_t length, CrosscheckReport& report) {
                 for (std::uint64_t i = first; i < first + length; ++i)
                   line_up.crosscheck().check(rays.ray(ray_class, i), ray_class, i, report);
               });
  }

  std::uint64_t share(std::uint64_t percent) const { return (options_.rays * percent + 99) / 100; }

  template <typename Check>
  void in_batches(std::uint64_t count, const Check& check) {
    parallel_for(count, batch_size, options_.threads, [&](std::size_t begin, std::size_t end) {
      CrosscheckReport report(engines_.size(), options_.kept);
      check(begin, end - begin, report);
      const std::lock_guard lock(mutex_);
      report_ += report;
      done_ += end - begin;
      if (progress_) progress_(done_);
    });
  }

  const Scene& scene_;
  const CrosscheckOptions& options_;
  const std::vector<Engine> engines_;
  const std::function<void(std::uint64_t)>& progress_;
  CrosscheckReport report_;
  std::uint64_t done_ = 0;
  std::mutex mutex_;
};

}  // namespace

bool can_be_reference(const Engine& engine) {
  return engine.is_canonical() && engine.backend != Backend::brute_force;
}

std::vector<std::string> default_crosscheck_engines() {
  std::vector<std::string> engines = engine_names();
  const auto bvh = std::find(engines.begin(), engines.end(), backend_name(Backend::bvh));
  std::rotate(engines.begin(), bvh, bvh + 1);
  if (find_engine("embree")) std::erase(engines, backend_name(Backend::brute_force));
  return engines;
}

SceneCrosscheck crosscheck_scene(const Scene& scene, const CrosscheckOptions& options,
                                 const std::function<void(std::uint64_t)>& progress) {
  if (options.rays < 1 || options.rays > 1000000000000)
    throw Error("the number of rays must lie in [1, 10^12]");
  return Run(scene, options, progress).run();
}

RayCrosscheck crosscheck_ray(const Scene& scene, const Ray& ray, Placement placement,
                             const CrosscheckOptions& options) {
  std::vector<Engine> engines = ordered(options);
  if (std::none_of(engines.begin(), engines.end(),
                   [](const Engine& engine) { return engine.backend == Backend::brute_force; }))
    engines.push_back(named_engine(backend_name(Backend::brute_force), options.build));
  const LineUp line_up(placed_geometry(scene.geometry, placement), engines, 1);
  RayCrosscheck result;
  const Answer reference = ask(line_up.reference(), ray);
  for (std::size_t i = 0; i < engines.size(); ++i) {
    const CheckedEngine& engine = line_up.crosscheck().engines()[i];
    const Answer answer = ask(*engine.accelerator, ray);
    result.rows.push_back({engine.name, answer, line_up.crosscheck().compare(i, ray, reference, answer)});
  }
  if (is_finite(ray.origin) && is_finite(ray.direction) && max_abs(ray.direction) > 0)
    result.truth = judge_all(*line_up.geometry(), ray);
  return result;
}

}  // namespace twinray
