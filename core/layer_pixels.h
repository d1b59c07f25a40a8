// SPDX-License-Identifier: Apache-2.0
// How a film keeps one layer: at most 8 bytes a channel and pixel. Pixels count row by row. Different threads
// may add to different pixels at the same time. While none does, pixels [begin, end) can be saved as columns
// of numbers, and all pixels loaded from columns of as many, which throws Error where these are not such.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/exact_sums.h"
#include "core/rgb.h"

namespace twinray {

/// A layer whose pixels have the means of their samples.
class MeanPixels {
 public:
  MeanPixels(std::size_t pixels, std::size_t channels) : channels_(channels), sums_(pixels * channels) {}
  /// Adds samples, as ExactSums does.
  void add(std::size_t pixel, std::span<const Rgb> values);
  void merge(std::size_t pixel, const MeanPixels& other, std::size_t other_pixel);
  /// Of so many samples; black of none.
  Rgb mean(std::size_t pixel, std::uint32_t count) const;
  void save(std::size_t begin, std::size_t end, ColumnWriter& to) const {
    sums_.save(begin * channels_, end * channels_, to);
  }
  void load(ColumnReader& from) { sums_.load(from); }
  static constexpr std::size_t bytes(std::size_t channels) { return channels * ExactSums::bytes; }

 private:
  std::size_t channels_;
  ExactSums sums_;
};

/// The parts of light by one division.
class PartPixels {
 public:
  PartPixels(std::size_t pixels, std::size_t parts) : parts_(parts), sums_(pixels * parts * 3) {}
  /// Adds the parts of samples' radiance, sample by sample. They add up to it but for their rounding.
  void add(std::size_t pixel, std::span<const Rgb> parts);
  void merge(std::size_t pixel, const PartPixels& other, std::size_t other_pixel);
  /// The parts of the mean of so many samples, which they give to the last bit, added up as floats in any
  /// order.
  void read(std::size_t pixel, std::uint32_t count, const Rgb& mean, std::span<Rgb> parts) const;
  void save(std::size_t begin, std::size_t end, ColumnWriter& to) const {
    sums_.save(begin * parts_ * 3, end * parts_ * 3, to);
  }
  void load(ColumnReader& from) { sums_.load(from); }
  static constexpr std::size_t bytes(std::size_t parts) { return parts * 3 * ExactSums::bytes; }

 private:
  std::size_t parts_;
  ExactSums sums_;
};

/// A layer whose pixels have the value of one of their samples: of those that have a value at all the one
/// with the least index.
class FirstPixels {
 public:
  FirstPixels(std::size_t pixels, std::size_t channels)
      : channels_(channels), indices_(pixels, none), values_(pixels * channels) {}
  /// A sample has no value where its first channel is not a number.
  void add(std::size_t pixel, std::uint32_t sample_index, const Rgb& value);
  void merge(std::size_t pixel, const FirstPixels& other, std::size_t other_pixel);
  bool has(std::size_t pixel) const { return indices_[pixel] != none; }
  Rgb value(std::size_t pixel) const;
  void save(std::size_t begin, std::size_t end, ColumnWriter& to) const;
  void load(ColumnReader& from);
  static constexpr std::size_t bytes(std::size_t channels) {
    return sizeof(std::uint32_t) + channels * sizeof(float);
  }

 private:
  static constexpr std::uint32_t none = 0xffffffff;

  std::size_t channels_;
  std::vector<std::uint32_t> indices_;
  std::vector<float> values_;
};

}  // namespace twinray
