// SPDX-License-Identifier: Apache-2.0
// What is kept of a sample: its radiance, and whatever else is asked for, layer by layer.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/rgb.h"

namespace twinray {

/// What a layer of a picture shows. Of the surface that the camera ray hits first:
enum class Layer : std::size_t {
  color,   ///< The radiance that arrives; always kept.
  albedo,  ///< Its reflectance, in [0, 1]; black where nothing is hit.
  normal,  ///< Its unit shading normal on the viewer's side, x, y and z; zero where nothing is hit.
};
inline constexpr std::size_t layer_count = 3;

/// "color", "albedo", "normal".
inline std::string layer_name(Layer layer) {
  constexpr std::array<const char*, layer_count> names{"color", "albedo", "normal"};
  return names[std::size_t(layer)];
}

/// Where the records of samples are written: for each layer its values, one for each sample; none where the
/// layer is not asked for, which then costs nothing.
class RecordSpans {
 public:
  RecordSpans() = default;
  /// The radiance alone.
  explicit RecordSpans(std::span<Rgb> color) { columns_[std::size_t(Layer::color)] = color; }

  std::span<Rgb>& operator[](Layer layer) { return columns_[std::size_t(layer)]; }
  std::span<Rgb> operator[](Layer layer) const { return columns_[std::size_t(layer)]; }
  bool has(Layer layer) const { return !columns_[std::size_t(layer)].empty(); }
  /// Whether anything is asked for of the surface that is hit first.
  bool has_surface() const { return has(Layer::albedo) || has(Layer::normal); }
  /// Makes all values black.
  void clear() const {
    for (const std::span<Rgb>& column : columns_) std::fill(column.begin(), column.end(), Rgb{});
  }
  /// Those of `size` samples from `first` on.
  RecordSpans part(std::size_t first, std::size_t size) const {
    RecordSpans part;
    for (std::size_t i = 0; i < layer_count; ++i)
      if (!columns_[i].empty()) part.columns_[i] = columns_[i].subspan(first, size);
    return part;
  }

 private:
  std::array<std::span<Rgb>, layer_count> columns_;
};

/// The records of samples that are made together.
class Records {
 public:
  /// Room for `size` samples.
  Records(std::span<const Layer> layers, std::size_t size) {
    for (const Layer layer : layers) columns_[std::size_t(layer)].resize(size);
  }
  /// Of the first `size` samples.
  RecordSpans spans(std::size_t size) {
    RecordSpans spans;
    for (std::size_t i = 0; i < layer_count; ++i)
      if (!columns_[i].empty()) spans[Layer(i)] = std::span(columns_[i]).first(size);
    return spans;
  }

 private:
  std::array<std::vector<Rgb>, layer_count> columns_;
};

}  // namespace twinray
