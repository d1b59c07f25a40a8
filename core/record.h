// SPDX-License-Identifier: Apache-2.0
// What is kept of a sample: its radiance, and whatever else is asked for, layer by layer.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "core/layer.h"
#include "core/rgb.h"

namespace twinray {

/// What stands in a record of a layer until an integrator knows better: zero, which counts where the film
/// takes means; where it takes the first value, none.
inline Rgb blank_record(Layer layer) {
  constexpr float none = std::numeric_limits<float>::quiet_NaN();
  return layer_info(layer).gathering == Gathering::first ? Rgb{none, none, none} : Rgb{};
}

/// Where the records of samples are written: the radiance of each, and for each layer its values, in as many
/// channels as it has; none where the layer is not asked for, which then costs nothing.
class RecordSpans {
 public:
  RecordSpans() = default;
  /// The radiance alone.
  explicit RecordSpans(std::span<Rgb> color) : color_(color) {}

  std::span<Rgb> color() const { return color_; }
  std::span<Rgb>& operator[](Layer layer) { return columns_[std::size_t(layer)]; }
  std::span<Rgb> operator[](Layer layer) const { return columns_[std::size_t(layer)]; }
  bool has(Layer layer) const { return !columns_[std::size_t(layer)].empty(); }
  /// Whether any layer is asked for.
  bool has_layers() const {
    return std::any_of(columns_.begin(), columns_.end(), [](const auto& column) { return !column.empty(); });
  }
  /// Makes all radiance black, and all layers blank.
  void clear() const {
    std::fill(color_.begin(), color_.end(), Rgb{});
    for (std::size_t i = 0; i < layer_count; ++i)
      if (!columns_[i].empty()) std::fill(columns_[i].begin(), columns_[i].end(), blank_record(Layer(i)));
  }
  /// Those of `size` samples from `first` on.
  RecordSpans part(std::size_t first, std::size_t size) const {
    RecordSpans part(color_.subspan(first, size));
    for (std::size_t i = 0; i < layer_count; ++i)
      if (!columns_[i].empty()) part.columns_[i] = columns_[i].subspan(first, size);
    return part;
  }

 private:
  std::span<Rgb> color_;
  std::array<std::span<Rgb>, layer_count> columns_;
};

/// The records of samples that are made together.
class Records {
 public:
  /// Room for `size` samples.
  Records(std::span<const Layer> layers, std::size_t size) : color_(size) {
    for (const Layer layer : layers)
      if (layer_info(layer).gathering != Gathering::of_color) columns_[std::size_t(layer)].resize(size);
  }
  /// Of the first `size` samples.
  RecordSpans spans(std::size_t size) {
    RecordSpans spans(std::span<Rgb>(color_).first(size));
    for (std::size_t i = 0; i < layer_count; ++i)
      if (!columns_[i].empty()) spans[Layer(i)] = std::span(columns_[i]).first(size);
    return spans;
  }

 private:
  std::vector<Rgb> color_;
  std::array<std::vector<Rgb>, layer_count> columns_;
};

}  // namespace twinray
