// SPDX-License-Identifier: Apache-2.0
#include "bench/reading.h"

#include <filesystem>

#include "core/error.h"
#include "io/scene_file.h"

namespace twinray::bench {

ReadingStatistics measure_reading(const Workload& workload, const Rounds& rounds) {
  const std::string& file = workload.source().file;
  ReadingStatistics statistics{
      workload.source().name, 1e-6 * double(std::filesystem::file_size(file)), workload.primitives(), {}};
  const auto read = [&] {
    if (load_scene(file).scene.geometry->primitive_count() != workload.primitives())
      throw Error(file + " was changed while it was measured");
  };
  read();
  const auto measured = run_rounds({{"read", read}}, rounds);
  for (const Seconds& round : measured[0]) statistics.seconds.push_back(round.cpu);
  return statistics;
}

}  // namespace twinray::bench
