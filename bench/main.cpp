// SPDX-License-Identifier: Apache-2.0
// The benchmark program. Besides Google Benchmark's own options it takes --scenes=DIR: the folder of the
// well-known scenes; by default the one that the build was configured with.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <string>
#include <string_view>

#include "bench/workload.h"

namespace {

/// Takes --scenes=DIR out of the arguments.
std::string take_scenes(int& argc, char** argv) {
  constexpr std::string_view option = "--scenes=";
  std::string folder = TWINRAY_SCENES;
  int kept = 0;
  for (int i = 0; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word.starts_with(option))
      folder = word.substr(option.size());
    else
      argv[kept++] = argv[i];
  }
  argc = kept;
  return folder;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const std::string folder = take_scenes(argc, argv);
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    const auto workloads = twinray::bench::workloads(TWINRAY_OWN_SCENES, folder);
    twinray::bench::register_trace(workloads);
    twinray::bench::register_build(workloads);
    twinray::bench::register_render(workloads);
    benchmark::AddCustomContext("compiler", __VERSION__);
    benchmark::AddCustomContext("flags", TWINRAY_FLAGS);
    benchmark::AddCustomContext("threads", "1, but for build/");
    benchmark::AddCustomContext("libraries", TWINRAY_LIBRARIES " (Debian builds its Embree with assertions)");
    benchmark::RunSpecifiedBenchmarks();
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "twinray_bench: {}\n", error.what());
    return 1;
  }
}
