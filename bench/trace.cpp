// SPDX-License-Identifier: Apache-2.0
// trace/<engine>/<scene>/<camera|shadow|bounce>: single rays on one thread.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "bench/workload.h"

namespace twinray::bench {
namespace {

constexpr std::size_t brute_force_rays = 16;

void set_counters(benchmark::State& state, const Accelerator& accelerator, const std::vector<Ray>& rays,
                  RayKind kind) {
  QueryCounts counts;
  for (const Ray& ray : rays) {
    if (kind == RayKind::shadow)
      accelerator.any_hit(ray, counts);
    else
      accelerator.closest_hit(ray, counts);
  }
  const AccelStats stats = accelerator.stats();
  const auto per_ray = [&](std::uint64_t n) { return double(n) / double(rays.size()); };
  state.counters["rays/s"] =
      benchmark::Counter(double(state.iterations()) * double(rays.size()), benchmark::Counter::kIsRate);
  state.counters["nodes/ray"] = per_ray(counts.nodes);
  state.counters["primitives/ray"] = per_ray(counts.primitives);
  state.counters["bytes/triangle"] = double(stats.bytes) / double(std::max<std::size_t>(1, stats.primitives));
  state.counters["sah"] = stats.sah_cost;
}

void trace(benchmark::State& state, Workload& workload, const Engine& engine, RayKind kind) {
  const auto accelerator = workload.build(engine);
  if (const std::string wrong = workload.check(engine, *accelerator); !wrong.empty()) {
    state.SkipWithError(wrong.c_str());
    return;
  }
  std::vector<Ray> rays = workload.rays(kind);
  if (engine.backend == Backend::brute_force && rays.size() > brute_force_rays) rays.resize(brute_force_rays);
  if (rays.empty()) {
    state.SkipWithError("the picture has no such rays");
    return;
  }
  for (auto _ : state) {
    for (const Ray& ray : rays) {
      if (kind == RayKind::shadow)
        benchmark::DoNotOptimize(accelerator->any_hit(ray));
      else
        benchmark::DoNotOptimize(accelerator->closest_hit(ray));
    }
  }
  set_counters(state, *accelerator, rays, kind);
}

}  // namespace

void register_trace(const std::vector<std::shared_ptr<Workload>>& all) {
  for (const auto& workload : all)
    for (const Engine& engine : engines())
      for (const auto& [label, kind] :
           {std::pair{"camera", RayKind::camera}, {"shadow", RayKind::shadow}, {"bounce", RayKind::bounce}}) {
        const std::string name = fmt::format("trace/{}/{}/{}", engine.name, workload->name(), label);
        benchmark::RegisterBenchmark(name.c_str(), [workload, engine, kind = kind](benchmark::State& state) {
          trace(state, *workload, engine, kind);
        })->Unit(benchmark::kMillisecond);
      }
}

}  // namespace twinray::bench
