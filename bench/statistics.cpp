// SPDX-License-Identifier: Apache-2.0
#include "bench/statistics.h"

#include <algorithm>
#include <cmath>

namespace twinray::bench {
namespace {

/// The geometric means of one of the sets' lists, round by round; empty sets do not take part.
template <class List>
std::vector<double> means(const std::array<TraceStatistics, ray_sets.size()>& trace, const List& list) {
  std::vector<double> logs;
  int sets = 0;
  for (const TraceStatistics& statistics : trace) {
    const std::vector<double>& values = list(statistics);
    if (values.empty()) continue;
    if (logs.empty()) logs.resize(values.size());
    for (std::size_t i = 0; i < std::min(logs.size(), values.size()); ++i) logs[i] += std::log(values[i]);
    ++sets;
  }
  for (double& value : logs) value = std::exp(value / sets);
  return logs;
}

}  // namespace

Quartiles quartiles(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const auto at = [&](double part) {
    const double place = part * double(values.size() - 1);
    const std::size_t below = std::size_t(place);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    return values[below] + (values[above] - values[below]) * (place - double(below));
  };
  return {at(0.25), at(0.5), at(0.75)};
}

std::vector<double> EngineStatistics::mean_speed() const {
  return means(trace, [](const TraceStatistics& f) -> const std::vector<double>& { return f.speed; });
}

std::vector<double> EngineStatistics::mean_nanoseconds() const {
  return means(trace, [](const TraceStatistics& f) -> const std::vector<double>& { return f.nanoseconds; });
}

}  // namespace twinray::bench
