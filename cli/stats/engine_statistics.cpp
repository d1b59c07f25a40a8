// SPDX-License-Identifier: Apache-2.0
#include "cli/stats/engine_statistics.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>

#include "core/error.h"
#include "core/parallel.h"

namespace twinray {
namespace {

/// Rays that a thread takes at a time.
constexpr std::size_t grain = 1024;

/// All rays of a picture, by ray_kinds, and the first engine's answers to them.
struct RaySet {
  std::vector<Ray> rays;
  std::vector<Hit> expected;
};
using RaySets = std::array<RaySet, 3>;

RaySets record(const Scene& scene, const Recording& recording) {
  const std::vector<RecordedRay> recorded = record_rays(scene, recording);
  RaySets sets;
  for (std::size_t kind = 0; kind < ray_kinds.size(); ++kind)
    sets[kind].rays = rays_of_kind(recorded, ray_kinds[kind]);
  return sets;
}

/// The answers with their counts; t = 0 stands for a shadow ray that is blocked.
std::vector<Hit> counted_answers(const Accelerator& accelerator, RayKind kind, const std::vector<Ray>& rays,
                                 QueryCounts& counts) {
  std::vector<Hit> answers(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (kind != RayKind::shadow)
      answers[i] = accelerator.closest_hit({rays[i], &counts});
    else if (accelerator.any_hit({rays[i], &counts}))
      answers[i].t = 0;
  }
  return answers;
}

double seconds_of_pass(const Accelerator& accelerator, RayKind kind, const std::vector<Ray>& rays,
                       int threads) {
  std::atomic<std::size_t> hits = 0;  // Asked for, so that no query may be left out.
  const auto start = std::chrono::steady_clock::now();
  parallel_for(rays.size(), grain, threads, [&](std::size_t begin, std::size_t end) {
    std::size_t found = 0;
    for (std::size_t i = begin; i < end; ++i)
      found +=
          kind == RayKind::shadow ? accelerator.any_hit(rays[i]) : bool(accelerator.closest_hit(rays[i]));
    hits += found;
  });
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  return seconds.count();
}

double fastest_rate(const Accelerator& accelerator, RayKind kind, const std::vector<Ray>& rays,
                    const StatsOptions& options) {
  if (rays.empty()) return 0;
  double all = 0, fastest = 0;
  do {
    const double seconds = seconds_of_pass(accelerator, kind, rays, options.threads);
    all += seconds;
    if (seconds > 0) fastest = std::max(fastest, double(rays.size()) / seconds);
  } while (all < options.least_seconds);
  return fastest;
}

class Measurement {
 public:
  Measurement(const Scene& scene, const StatsOptions& options,
              const std::function<void(const std::string&)>& progress)
      : scene_(scene), options_(options), progress_(progress) {}

  SceneStatistics run() {
    report("recording rays");
    sets_ = record(scene_, options_.recording);
    SceneStatistics statistics;
    const std::vector<AgreementEngine> engines = stats_engines();
    for (std::size_t i = 0; i < engines.size(); ++i) {
      if (engines[i].backend == Backend::brute_force && !may_use_brute_force()) {
        statistics.is_brute_force_left_out = true;
        continue;
      }
      label_ = fmt::format("engine {} of {} | {}", i + 1, engines.size(), engines[i].name);
      statistics.engines.push_back(measure(engines[i]));
    }
    return statistics;
  }

 private:
  void report(const std::string& text) const {
    if (progress_) progress_(text);
  }

  bool may_use_brute_force() const {
    double rays = 0;
    for (const RaySet& set : sets_) rays += double(set.rays.size());
    return rays * double(scene_.geometry->seen_primitives()) <= options_.brute_force_tests;
  }

  EngineStatistics measure(const AgreementEngine& engine) {
    report(label_ + " | building");
    BuildOptions build = engine.build;
    build.threads = options_.threads;
    const auto accelerator = build_accelerator(engine.backend, scene_.geometry, build);
    EngineStatistics statistics{.name = engine.name, .build = accelerator->stats()};
    statistics.has_tree = statistics.build.tree.has_value();
    statistics.has_primitives = engine.backend != Backend::embree_native;
    for (std::size_t kind = 0; kind < ray_kinds.size(); ++kind) {
      report(fmt::format("{} | {} rays", label_, ray_kind_name(ray_kinds[kind])));
      statistics.rays[kind] = shoot(engine, *accelerator, kind);
    }
    return statistics;
  }

  RayStatistics shoot(const AgreementEngine& engine, const Accelerator& accelerator, std::size_t kind) {
    RaySet& set = sets_[kind];
    RayStatistics statistics{.rays = set.rays.size()};
    std::vector<Hit> answers = counted_answers(accelerator, ray_kinds[kind], set.rays, statistics.counts);
    if (set.expected.empty())
      set.expected = std::move(answers);
    else if (engine.backend != Backend::embree_native)
      check(engine, kind, answers);
    statistics.rays_per_second = fastest_rate(accelerator, ray_kinds[kind], set.rays, options_);
    return statistics;
  }

  void check(const AgreementEngine& engine, std::size_t kind, const std::vector<Hit>& answers) const {
    const auto found = std::mismatch(answers.begin(), answers.end(), sets_[kind].expected.begin()).first;
    if (found != answers.end())
      throw Error(fmt::format("{} answers {} ray {} otherwise than {}; see twinray crosscheck", engine.name,
                              ray_kind_name(ray_kinds[kind]), found - answers.begin(),
                              stats_engines().front().name));
  }

  const Scene& scene_;
  const StatsOptions& options_;
  const std::function<void(const std::string&)>& progress_;
  RaySets sets_;
  std::string label_;
};

}  // namespace

std::string ray_kind_name(RayKind kind) {
  switch (kind) {
    case RayKind::camera:
      return "camera";
    case RayKind::shadow:
      return "shadow";
    default:
      return "bounce";
  }
}

std::vector<AgreementEngine> stats_engines() {
  std::vector<AgreementEngine> engines = canonical_engines();
  if (const auto native = find_engine("embree-native")) engines.insert(engines.end() - 1, {*native});
  return engines;
}

SceneStatistics measure_engines(const Scene& scene, const StatsOptions& options,
                                const std::function<void(const std::string&)>& progress) {
  return Measurement(scene, options, progress).run();
}

}  // namespace twinray
