// SPDX-License-Identifier: Apache-2.0
// Which things cover a pixel, and how much of it each: how many of its samples have each id.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <vector>

namespace twinray {

class ColumnReader;
class ColumnWriter;

/// How many samples of a pixel have an id.
struct Coverage {
  std::uint32_t id = 0;  ///< From 1 on.
  std::uint32_t count = 0;
  bool operator==(const Coverage&) const = default;
};

/// Pixels count row by row. Different threads may add to different pixels at the same time.
class CoveragePixels {
 public:
  explicit CoveragePixels(std::size_t pixels) : few_(pixels) {}
  CoveragePixels(const CoveragePixels& other) : few_(other.few_), more_(other.more_) {}
  CoveragePixels& operator=(const CoveragePixels& other) {
    few_ = other.few_;
    more_ = other.more_;
    return *this;
  }
  /// Adds samples of one id; those of id 0 count for nothing.
  void add(std::size_t pixel, const Coverage& samples);
  void merge(std::size_t pixel, const CoveragePixels& other, std::size_t other_pixel);
  /// All ids of a pixel in their order. Not while others add to it.
  std::vector<Coverage> at(std::size_t pixel) const;
  /// As the other layers (core/layer_pixels.h); the columns do not depend on the order of the samples.
  void save(std::size_t begin, std::size_t end, ColumnWriter& to) const;
  void load(ColumnReader& from);
  static constexpr std::size_t together = 4;  ///< Most pixels have no more ids.
  static constexpr std::size_t bytes = together * sizeof(Coverage);

 private:
  using More = std::map<std::size_t, std::map<std::uint32_t, std::uint32_t>>;

  std::vector<std::array<Coverage, together>> few_;
  std::mutex mutex_;
  More more_;  ///< By pixel, the counts of further ids.
};

}  // namespace twinray
