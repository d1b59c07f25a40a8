// SPDX-License-Identifier: Apache-2.0
#include "bench/trace.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "bench/asking.h"
#include "bench/pattern.h"
#include "core/parallel.h"

namespace twinray::bench {
namespace {

/// What an engine is expected to hold for a primitive, in bytes; and the part of the memory that all may
/// take.
constexpr double bytes_per_primitive = 250;
constexpr double share_of_memory = 0.25;
/// No more building once all of a group's builds took this long.
constexpr double enough_build_seconds = 4;
/// From all over a set; with all it would take too long.
constexpr std::size_t brute_force_rays = 16;

std::size_t engines_at_a_time(std::size_t primitives) {
  const double memory = double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGESIZE));
  const double each = bytes_per_primitive * double(std::max<std::size_t>(1, primitives));
  return std::size_t(std::clamp(share_of_memory * memory / each, 2.0, 64.0));
}

/// The baseline and some more engines, in memory at the same time.
class Group {
 public:
  Group(Workload& workload, std::vector<Engine> engines, const TraceOptions& options)
      : workload_(workload), engines_(std::move(engines)), options_(options), statistics_(engines_.size()) {
    for (std::size_t i = 0; i < engines_.size(); ++i) statistics_[i].name = engines_[i].name;
  }

  void build() {
    accelerators_.resize(engines_.size());
    std::vector<Timed> timed;
    for (std::size_t i = 0; i < engines_.size(); ++i)
      timed.push_back({engines_[i].name, [this, i] {
                         accelerators_[i].reset();  // Never two of one engine in memory.
                         accelerators_[i] = workload_.build(engines_[i], available_threads());
                       }});
    double seconds = 0;
    const Rounds once{.count = 1, .least_seconds = 0, .clock = Clock::process};
    for (int round = 0; round < options_.most_build_rounds && seconds < enough_build_seconds; ++round) {
      const auto results = run_rounds(timed, once);
      for (std::size_t i = 0; i < engines_.size(); ++i) {
        statistics_[i].build.wall_seconds.push_back(results[i][0].wall);
        statistics_[i].build.cpu_seconds.push_back(results[i][0].cpu);
        seconds += results[i][0].wall;
      }
    }
    for (std::size_t i = 0; i < engines_.size(); ++i) statistics_[i].build.stats = accelerators_[i]->stats();
  }

  void check() {
    for (std::size_t i = 0; i < engines_.size(); ++i)
      statistics_[i].complaint = workload_.check(engines_[i], *accelerators_[i]);
  }

  void trace(std::size_t set) {
    const std::vector<Ray>& all = workload_.rays(set);
    const std::vector<Ray> few = every(all.size() / brute_force_rays + 1, all);
    std::vector<std::size_t> sound;  // The engines that may be timed.
    std::vector<Timed> timed;
    for (std::size_t i = 0; i < engines_.size(); ++i) {
      const std::span<const Ray> rays = engines_[i].backend == Backend::brute_force ? few : all;
      if (rays.empty() || !statistics_[i].complaint.empty()) continue;
      sound.push_back(i);
      timed.push_back({engines_[i].name, [this, i, set, rays] {
                         shoot(engines_[i], *accelerators_[i], ray_sets[set].kind, rays);
                       }});
      count(i, set, rays);
    }
    const auto results = run_rounds(timed, options_.rounds);
    for (std::size_t k = 0; k < sound.size(); ++k) {
      TraceStatistics& statistics = statistics_[sound[k]].trace[set];
      for (const Seconds& seconds : results[k])
        statistics.nanoseconds.push_back(1e9 * seconds.cpu / double(statistics.rays));
    }
    const std::vector<double>& baseline = statistics_.front().trace[set].nanoseconds;
    for (EngineStatistics& statistics : statistics_)
      for (std::size_t i = 0; i < std::min(baseline.size(), statistics.trace[set].nanoseconds.size()); ++i)
        statistics.trace[set].speed.push_back(baseline[i] / statistics.trace[set].nanoseconds[i]);
  }

  const std::vector<EngineStatistics>& statistics() const { return statistics_; }

 private:
  void count(std::size_t engine, std::size_t set, std::span<const Ray> rays) {
    QueryCounts counts;
    for (const Ray& ray : rays) {
      if (ray_sets[set].kind == RayKind::shadow)
        accelerators_[engine]->any_hit({ray, &counts});
      else
        accelerators_[engine]->closest_hit({ray, &counts});
    }
    TraceStatistics& statistics = statistics_[engine].trace[set];
    statistics.rays = rays.size();
    const auto per_ray = [&](std::uint64_t count) {
      return count > 0 ? std::optional(double(count) / double(rays.size())) : std::nullopt;
    };
    statistics.nodes_per_ray = per_ray(counts.nodes);
    statistics.primitives_per_ray = per_ray(counts.primitives);
  }

  Workload& workload_;
  std::vector<Engine> engines_;
  const TraceOptions& options_;
  std::vector<EngineStatistics> statistics_;
  std::vector<std::unique_ptr<Accelerator>> accelerators_;
};

std::vector<Engine> wanted_engines(const Workload& workload, const TraceOptions& options) {
  const bool has_spheres = workload.scene().geometry->sphere_count() > 0;
  std::vector<Engine> wanted;
  const Pattern pattern(options.engine_pattern);
  for (const Engine& engine : engines()) {
    const bool is_named = pattern.matches(engine.name);
    const bool takes_part =
        (engine.wanted != Wanted::full || options.is_full || !options.engine_pattern.empty()) &&
        (engine.wanted != Wanted::small || workload.primitives() <= small_scene) &&
        (engine.takes_spheres() || !has_spheres);
    if (wanted.empty() || (is_named && takes_part)) wanted.push_back(engine);
  }
  return wanted;
}

}  // namespace

SceneStatistics measure_scene(Workload& workload, const TraceOptions& options,
                              const std::function<void(const std::string&)>& progress) {
  SceneStatistics scene{workload.source().name, workload.source().family, workload.primitives(), {}};
  const std::vector<Engine> all = wanted_engines(workload, options);
  const std::size_t others = engines_at_a_time(workload.primitives()) - 1;
  for (std::size_t begin = 1; begin == 1 || begin < all.size(); begin += others) {
    const std::size_t end = std::min(all.size(), begin + others);
    std::vector<Engine> together(all.begin() + std::ptrdiff_t(begin), all.begin() + std::ptrdiff_t(end));
    together.insert(together.begin(), all.front());
    Group group(workload, together, options);
    progress(fmt::format("building {} engines", together.size()));
    group.build();
    progress("comparing their answers");
    group.check();
    for (std::size_t set = 0; set < ray_sets.size(); ++set) {
      progress(fmt::format("{} rays", ray_sets[set].title));
      group.trace(set);
    }
    const auto& statistics = group.statistics();
    scene.engines.insert(scene.engines.end(), statistics.begin() + (begin == 1 ? 0 : 1), statistics.end());
  }
  return scene;
}

}  // namespace twinray::bench
