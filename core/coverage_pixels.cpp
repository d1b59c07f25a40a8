// SPDX-License-Identifier: Apache-2.0
#include "core/coverage_pixels.h"

#include <algorithm>
#include <span>

#include "core/columns.h"
#include "core/error.h"

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

void CoveragePixels::save(std::size_t begin, std::size_t end, ColumnWriter& to) const {
  std::vector<std::uint32_t> lengths;
  std::vector<Coverage> all;
  for (std::size_t pixel = begin; pixel < end; ++pixel) {
    const std::vector<Coverage> here = at(pixel);
    lengths.push_back(std::uint32_t(here.size()));
    all.insert(all.end(), here.begin(), here.end());
  }
  to.put(std::span<const std::uint32_t>(lengths));
  to.put(std::span<const Coverage>(all));
}

void CoveragePixels::load(ColumnReader& from) {
  *this = CoveragePixels(few_.size());
  const auto lengths = from.take_column<std::uint32_t>(few_.size());
  std::size_t total = 0;
  for (const std::uint32_t length : lengths) total += length;
  const auto all = from.take_column<Coverage>(total);
  auto next = all.begin();
  for (std::size_t pixel = 0; pixel < lengths.size(); ++pixel)
    for (std::uint32_t i = 0; i < lengths[pixel]; ++i) add(pixel, *next++);
}

}  // namespace twinray
