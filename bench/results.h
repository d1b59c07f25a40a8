// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "bench/reading.h"
#include "bench/statistics.h"
#include "bench/whole.h"

namespace twinray::bench {

/// All that one run of the benchmarks found.
struct Results {
  std::vector<std::pair<std::string, std::string>> machine;
  int rounds = 0;
  int width = 0, height = 0;  ///< Of the picture whose rays were recorded.
  std::vector<SceneStatistics> scenes;
  std::vector<ReadingStatistics> readings;
  std::vector<PictureOfScene> pictures;
  std::vector<ErrorStatistics> errors;
  std::vector<ScalingStatistics> scalings;
};

}  // namespace twinray::bench
