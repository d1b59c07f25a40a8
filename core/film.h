// SPDX-License-Identifier: Apache-2.0
// The image while it is being made: exact sums, so that no order and no partition of the samples changes a
// bit.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/radiance.h"
#include "core/rgb.h"

namespace twinray {

/// A sum of radiances in 96-bit fixed point, unit 2^-43: addition is exact, so it has neither order nor
/// rounding.
class FixedSum {
 public:
  /// Adds x, rounded to the nearest unit. |x| <= max_radiance; the sum of up to 2^22 such numbers does not
  /// overflow.
  void add(double x);
  FixedSum& operator+=(const FixedSum& other);
  /// The sum, rounded to double.
  double value() const;
  friend bool operator==(const FixedSum&, const FixedSum&) = default;

 private:
  std::array<std::uint32_t, 3> words_{};  ///< Two's complement, the least word first.
};

/// A sum of squares of radiances in 128-bit fixed point, unit 2^-46.
class FixedSquareSum {
 public:
  /// Adds x^2, rounded up to the unit, so that what is too dim to be resolved counts as noise and not as
  /// certainty. |x| <= max_radiance up to a double's rounding; the sum of up to 2^22 such squares does not
  /// overflow.
  void add_square_of(double x);
  FixedSquareSum& operator+=(const FixedSquareSum& other);
  /// The sum, rounded to double.
  double value() const;
  friend bool operator==(const FixedSquareSum&, const FixedSquareSum&) = default;

 private:
  __extension__ unsigned __int128 units_ = 0;
};

/// What a pixel of one layer has gathered.
struct PixelSums {
  FixedSum r, g, b;
  std::uint32_t count = 0;           ///< Accepted samples.
  std::uint32_t rejected = 0;        ///< Samples that were not finite, or out of range.
  std::uint32_t rejected_index = 0;  ///< The least index of those; 0 where there is none.
  FixedSquareSum luminance_squared;  ///< Second moment of the luminance.

  Rgb mean() const;  ///< Black without samples.
  double luminance_mean() const;
  /// Unbiased (1 / (n - 1)) variance of the luminance of one sample; 0 for fewer than two. Never negative.
  /// Too large by up to 2^-46 n / (n - 1).
  double luminance_variance() const;
  /// One more sample that is not accepted.
  void reject(std::uint32_t sample_index);
  PixelSums& operator+=(const PixelSums& other);
  friend bool operator==(const PixelSums&, const PixelSums&) = default;
};
/// A picture of 8192 x 8192 pixels takes 4 GB.
static_assert(sizeof(PixelSums) == 64);

/// A sample that was not accepted: not finite, or beyond the range of the sums.
struct RejectedSample {
  int x = 0, y = 0;
  std::uint32_t index = 0;
  std::size_t layer = 0;
};

/// A rectangle of pixels: x in [x0, x1), y in [y0, y1).
struct PixelRect {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  int width() const { return x1 - x0; }
  int height() const { return y1 - y0; }
  friend bool operator==(const PixelRect&, const PixelRect&) = default;
};

/// A full frame, of which `window` is rendered, with named layers ("color" first; albedo, normal, ... when
/// asked for), 64 bytes a pixel and layer. Pixels count from the top left. Different threads may add to
/// different pixels at the same time.
class Film {
 public:
  /// A component may lie in [-max_value, max_value].
  static constexpr float max_value = max_radiance;
  static constexpr std::uint32_t max_samples = 1u << 22;

  /// Throws Error for a frame outside [1, 65536]^2, a window that is empty or not within it, or no layer.
  Film(int frame_width, int frame_height, PixelRect window, std::vector<std::string> layers = {"color"});

  int frame_width() const { return frame_width_; }
  int frame_height() const { return frame_height_; }
  const PixelRect& window() const { return window_; }
  const std::vector<std::string>& layers() const { return layers_; }

  /// Adds one sample to a pixel of the window, the max_samples-th at most. False, and only counted, where it
  /// is not finite or out of range: in this layer alone.
  bool add(std::size_t layer, int x, int y, std::uint32_t sample_index, const Rgb& value);

  const PixelSums& pixel(std::size_t layer, int x, int y) const;
  /// Of all pixels and layers.
  std::uint64_t rejected_count() const;
  /// The first rejected sample in the order (y, x, index, layer), so that it does not depend on threads; none
  /// if count is 0.
  RejectedSample first_rejected() const;
  /// Memory of a film with that many pixels and layers.
  static constexpr std::uint64_t bytes(std::uint64_t pixels, std::uint64_t layers = 1) {
    return pixels * layers * sizeof(PixelSums);
  }

  /// Adds the samples of a film of the same frame and layers whose window lies within this one. Throws Error
  /// otherwise, or where a pixel would have more than max_samples, and leaves this film as it was.
  void merge(const Film& other);

 private:
  std::size_t offset(std::size_t layer, int x, int y) const;
  void check_mergeable(const Film& other) const;
  template <class Visit>
  void for_each_sum(const Visit& visit) const {
    for (std::size_t layer = 0; layer < layers_.size(); ++layer)
      for (int y = window_.y0; y < window_.y1; ++y)
        for (int x = window_.x0; x < window_.x1; ++x) visit(layer, x, y, pixel(layer, x, y));
  }

  int frame_width_, frame_height_;
  PixelRect window_;
  std::vector<std::string> layers_;
  std::vector<PixelSums> pixels_;  ///< Layer after layer, row by row.
};

}  // namespace twinray
