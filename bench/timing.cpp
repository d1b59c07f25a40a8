// SPDX-License-Identifier: Apache-2.0
#include "bench/timing.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/error.h"

namespace twinray::bench {
namespace {

/// Keeps the runs and prints nothing.
class Collector final : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.error_occurred) throw Error(run.benchmark_name() + ": " + run.error_message);
      const double iterations = double(run.iterations);
      seconds_[run.run_name.function_name] = {run.cpu_accumulated_time / iterations,
                                              run.real_accumulated_time / iterations};
    }
  }
  const Seconds& of(const std::string& name) const { return seconds_.at(name); }

 private:
  std::map<std::string, Seconds> seconds_;
};

class Runner {
 public:
  Runner(const std::vector<Timed>& timed, Clock clock)
      : timed_(timed), clock_(clock), iterations_(timed.size(), 1) {}

  /// One iteration of each; from then on as many as take so long.
  void calibrate(double least_seconds) {
    const std::vector<Seconds> once = run(0);
    for (std::size_t i = 0; i < timed_.size(); ++i)
      iterations_[i] =
          std::max<std::int64_t>(1, std::int64_t(std::ceil(least_seconds / std::max(once[i].cpu, 1e-7))));
  }

  /// All bodies in turn, beginning with number `first`.
  std::vector<Seconds> run(std::size_t first) const {
    benchmark::ClearRegisteredBenchmarks();
    for (std::size_t k = 0; k < timed_.size(); ++k) enlist((first + k) % timed_.size());
    Collector collector;
    benchmark::RunSpecifiedBenchmarks(&collector, "all");
    std::vector<Seconds> seconds;
    for (std::size_t i = 0; i < timed_.size(); ++i) seconds.push_back(collector.of(label(i)));
    return seconds;
  }

 private:
  static std::string label(std::size_t index) { return std::to_string(index); }

  void enlist(std::size_t index) const {
    const std::function<void()>& body = timed_[index].body;
    auto* const entry = benchmark::RegisterBenchmark(label(index).c_str(), [&body](benchmark::State& state) {
      for (auto _ : state) body();
    });
    entry->Iterations(iterations_[index]);
    if (clock_ == Clock::process) entry->MeasureProcessCPUTime();
  }

  const std::vector<Timed>& timed_;
  Clock clock_;
  std::vector<std::int64_t> iterations_;
};

}  // namespace

std::vector<std::vector<Seconds>> run_rounds(const std::vector<Timed>& timed, const Rounds& rounds) {
  std::vector<std::vector<Seconds>> results(timed.size());
  if (timed.empty()) return results;
  Runner runner(timed, rounds.clock);
  if (rounds.least_seconds > 0) runner.calibrate(rounds.least_seconds);
  for (int round = 0; round < rounds.count; ++round) {
    const std::vector<Seconds> seconds = runner.run(std::size_t(round));
    for (std::size_t i = 0; i < timed.size(); ++i) results[i].push_back(seconds[i]);
  }
  return results;
}

}  // namespace twinray::bench
