// SPDX-License-Identifier: Apache-2.0
// render/<engine>/<scene>: a whole picture on one thread, and beside it replay/<engine>/<scene>: the same
// rays in the same order, without the renderer. Both count pixel samples per second, so their ratio is what
// the renderer costs.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "bench/workload.h"
#include "integrators/path.h"
#include "integrators/render.h"

namespace twinray::bench {
namespace {

/// CS184's picture: 480 x 360, five bounces, one light sample; one sample a pixel, as it is recorded too.
constexpr Recording picture{480, 360, 1, 5};

void set_rate(benchmark::State& state) {
  state.counters["samples/s"] =
      benchmark::Counter(double(state.iterations()) * picture.width * picture.height * picture.samples,
                         benchmark::Counter::kIsRate);
}

bool is_wrong(benchmark::State& state, Workload& workload, const Engine& engine,
              const Accelerator& accelerator) {
  const std::string wrong = workload.check(engine, accelerator);
  if (!wrong.empty()) state.SkipWithError(wrong.c_str());
  return !wrong.empty();
}

void whole(benchmark::State& state, Workload& workload, const Engine& engine) {
  const auto accelerator = workload.build(engine);
  if (is_wrong(state, workload, engine, *accelerator)) return;
  const PathIntegrator path(workload.scene(), {.max_depth = picture.max_depth});
  const RenderOptions options{
      .width = picture.width, .height = picture.height, .samples = picture.samples, .threads = 1};
  for (auto _ : state)
    benchmark::DoNotOptimize(render(workload.scene(), *accelerator, path, options).rays.total());
  set_rate(state);
}

void replay(benchmark::State& state, Workload& workload, const Engine& engine) {
  const auto accelerator = workload.build(engine);
  if (is_wrong(state, workload, engine, *accelerator)) return;
  const std::vector<RecordedRay> recorded = record_rays(workload.scene(), picture);
  for (auto _ : state)
    for (const RecordedRay& entry : recorded) {
      if (entry.kind == RayKind::shadow)
        benchmark::DoNotOptimize(accelerator->any_hit(entry.ray));
      else
        benchmark::DoNotOptimize(accelerator->closest_hit(entry.ray));
    }
  set_rate(state);
}

}  // namespace

void register_render(const std::vector<std::shared_ptr<Workload>>& all) {
  for (const auto& workload : all)
    for (const Engine& engine : engines()) {
      if (engine.backend == Backend::brute_force) continue;
      const std::string suffix = fmt::format("{}/{}", engine.name, workload->name());
      benchmark::RegisterBenchmark(("render/" + suffix).c_str(), [workload, engine](benchmark::State& state) {
        whole(state, *workload, engine);
      })->Unit(benchmark::kMillisecond);
      benchmark::RegisterBenchmark(("replay/" + suffix).c_str(), [workload, engine](benchmark::State& state) {
        replay(state, *workload, engine);
      })->Unit(benchmark::kMillisecond);
    }
}

}  // namespace twinray::bench
