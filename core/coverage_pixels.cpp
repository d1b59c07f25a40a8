// SPDX-License-Identifier: Apache-2.0
#include "core/coverage_pixels.h"

#include <algorithm>

namespace twinray {

void CoveragePixels::add(std::size_t pixel, const Coverage& samples) {
  if (samples.id == 0) return;
  for (Coverage& place : few_[pixel]) {
    if (place.id != samples.id && place.id != 0) continue;
    place = {samples.id, place.count + samples.count};
    return;
  }
  const std::lock_guard lock(mutex_);
  more_[pixel][samples.id] += samples.count;
}

void CoveragePixels::merge(std::size_t pixel, const CoveragePixels& other, std::size_t other_pixel) {
  for (const Coverage& samples : other.at(other_pixel)) add(pixel, samples);
}

std::vector<Coverage> CoveragePixels::at(std::size_t pixel) const {
  std::vector<Coverage> all;
  for (const Coverage& samples : few_[pixel])
    if (samples.id != 0) all.push_back(samples);
  if (const auto further = more_.find(pixel); further != more_.end())
    for (const auto& [id, count] : further->second) all.push_back({id, count});
  std::sort(all.begin(), all.end(), [](const Coverage& a, const Coverage& b) { return a.id < b.id; });
  return all;
}

}  // namespace twinray
