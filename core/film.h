// SPDX-License-Identifier: Apache-2.0
// The image while it is being made: exact sums, so that no order and no partition of the samples changes a
// bit.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "core/coverage_pixels.h"
#include "core/fixed_sum.h"
#include "core/layer.h"
#include "core/layer_pixels.h"
#include "core/record.h"
#include "core/rgb.h"

namespace twinray {

/// What a pixel has gathered of its samples' radiance.
struct alignas(64) PixelSums {
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
/// A picture of 8192 x 8192 pixels takes 4 GB. Each pixel is one line of a cache.
static_assert(sizeof(PixelSums) == 64);

class ColumnReader;
class ColumnWriter;

/// A sample that was not accepted: not finite, or beyond the range of the sums.
struct RejectedSample {
  int x = 0, y = 0;
  std::uint32_t index = 0;
};

/// A rectangle of pixels: x in [x0, x1), y in [y0, y1).
struct PixelRect {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  int width() const { return x1 - x0; }
  int height() const { return y1 - y0; }
  friend bool operator==(const PixelRect&, const PixelRect&) = default;
};

/// A frame, and of its pixels and those beside it a `window`: colours, 64 bytes a pixel, and the layers and
/// parts of the light that are asked for, at most 8 bytes a channel and pixel. Pixels count from the top
/// left. Different threads may add to different pixels at the same time.
class Film {
 public:
  /// A component may lie in [-max_value, max_value].
  static constexpr float max_value = max_radiance;
  static constexpr std::uint32_t max_samples = 1u << 22;

  /// Throws Error for a frame outside [1, 65536]^2, or a window that is empty or too far away.
  Film(int frame_width, int frame_height, PixelRect window, FilmContents contents = {});

  int frame_width() const { return frame_width_; }
  int frame_height() const { return frame_height_; }
  const PixelRect& window() const { return window_; }
  /// What is kept besides the colours.
  const FilmContents& contents() const { return contents_; }
  const std::vector<Layer>& layers() const { return contents_.layers; }

  /// Adds one sample to a pixel of the window, the max_samples-th at most: one of the records, in which all
  /// that the film keeps is asked for. False, and only counted, where the radiance is not finite or out of
  /// range.
  bool add(int x, int y, std::uint32_t sample_index, const RecordSpans& records, std::size_t record);
  /// The same with `count` records from `record` on, of samples with successive indices.
  void add(int x, int y, std::uint32_t first_index, const RecordSpans& records, std::size_t record,
           std::size_t count);
  /// The same to a film of colours alone.
  bool add(int x, int y, std::uint32_t sample_index, Rgb color) {
    return add(x, y, sample_index, RecordSpans({&color, 1}), 0);
  }

  const PixelSums& pixel(int x, int y) const { return pixels_[offset(x, y)]; }
  /// Asks for the memory of a pixel that will be read and added to.
  void prefetch(int x, int y) const { __builtin_prefetch(&pixels_[offset(x, y)], 1); }
  /// A pixel's value in a layer, by its number among layers(), in as many channels as that has. Of coverage,
  /// nothing.
  Rgb value(std::size_t layer, int x, int y) const;
  /// Of a layer of coverage: how many of a pixel's samples have each id, in the order of these.
  std::vector<Coverage> coverage(std::size_t layer, int x, int y) const;
  /// Writes the parts of a pixel's colour by one division that is kept: they give its mean, added up as
  /// floats in any order.
  void read_parts(Division division, int x, int y, std::span<Rgb> parts) const;
  /// Of all pixels.
  std::uint64_t rejected_count() const;
  /// The first rejected sample in the order (y, x, index), so that it does not depend on threads; none if
  /// count is 0.
  RejectedSample first_rejected() const;
  /// Memory of a film with that many pixels and these contents.
  static std::uint64_t bytes(std::uint64_t pixels, const FilmContents& contents = {});

  /// Adds the samples of a film of the same frame and contents whose window lies within this one. Throws
  /// Error otherwise, or where a pixel would have more than max_samples, and leaves this film as it was.
  void merge(const Film& other);

  /// Of the rows [y0, y1) of the window all that is kept, as columns of numbers: films that are equal give
  /// the same bytes. Not while samples are added.
  void save(int y0, int y1, ColumnWriter& to) const;
  /// In place of all samples, those of columns of the same frame, contents and window, which may be rows of a
  /// larger one. Throws Error where they are not such columns; the film is then of no use.
  void load(ColumnReader& from);

 private:
  /// How a layer is kept; not at all where the colours say what it is.
  using LayerPixels = std::variant<std::monostate, MeanPixels, FirstPixels, CoveragePixels>;
  static LayerPixels make_pixels(Layer layer, std::size_t pixels);
  /// What accepted samples with successive indices have besides their colours.
  void add_layers(std::size_t pixel, std::uint32_t first_index, const RecordSpans& records,
                  std::size_t record, std::size_t count);
  std::size_t offset(int x, int y) const;
  void check_mergeable(const Film& other) const;
  void merge_layer(LayerPixels& own, const LayerPixels& other, std::size_t to, std::size_t from);
  template <class Visit>
  void for_each_pixel(const Visit& visit) const {
    for (int y = window_.y0; y < window_.y1; ++y)
      for (int x = window_.x0; x < window_.x1; ++x) visit(x, y);
  }

  int frame_width_, frame_height_;
  PixelRect window_;
  FilmContents contents_;
  std::vector<PixelSums> pixels_;          ///< Row by row.
  std::vector<LayerPixels> layer_pixels_;  ///< Of each layer.
  std::vector<PartPixels> part_pixels_;    ///< Of each division.
};

}  // namespace twinray
