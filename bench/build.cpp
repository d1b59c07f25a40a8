// SPDX-License-Identifier: Apache-2.0
// build/<engine>/<scene>/<threads>: from a geometry to a finished accelerator.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "bench/workload.h"
#include "core/parallel.h"

namespace twinray::bench {
namespace {

void build(benchmark::State& state, Workload& workload, const Engine& engine) {
  if (const std::string wrong = workload.check(engine, *workload.build(engine)); !wrong.empty()) {
    state.SkipWithError(wrong.c_str());
    return;
  }
  AccelStats stats;
  for (auto _ : state) stats = workload.build(engine)->stats();
  state.counters["triangles/s"] =
      benchmark::Counter(double(state.iterations()) * double(stats.primitives), benchmark::Counter::kIsRate);
  state.counters["bytes/triangle"] = double(stats.bytes) / double(std::max<std::size_t>(1, stats.primitives));
  state.counters["sah"] = stats.sah_cost;
}

}  // namespace

void register_build(const std::vector<std::shared_ptr<Workload>>& all) {
  for (const auto& workload : all)
    for (Engine engine : engines())
      for (const int threads : {1, available_threads()}) {
        if (engine.backend == Backend::brute_force) continue;
        engine.options.threads = threads;
        const std::string name =
            fmt::format("build/{}/{}/threads:{}", engine.name, workload->name(), threads);
        benchmark::RegisterBenchmark(
            name.c_str(), [workload, engine](benchmark::State& state) { build(state, *workload, engine); })
            ->Unit(benchmark::kMillisecond)
            ->UseRealTime();
      }
}

}  // namespace twinray::bench
