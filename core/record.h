// SPDX-License-Identifier: Apache-2.0
// What is kept of a sample: its radiance, and whatever else is asked for, layer by layer.
#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/layer.h"
#include "core/rgb.h"

namespace twinray {

/// What stands in a record of a layer until an integrator knows better: zero, which counts where the film
/// takes means, and is no id; where it takes the first value, none.
inline Rgb blank_record(Layer layer) {
  constexpr float none = std::numeric_limits<float>::quiet_NaN();
  return layer_info(layer).gathering == Gathering::first ? Rgb{none, none, none} : Rgb{};
}

/// Of a layer of coverage: an id, from 1 on, all of whose bits are kept.
inline Rgb record_id(std::uint32_t id) { return {std::bit_cast<float>(id), 0, 0}; }
/// 0 where there is none.
inline std::uint32_t recorded_id(const Rgb& record) { return std::bit_cast<std::uint32_t>(record.r); }

/// The parts of the samples' light by one division: a row for each sample.
class PartRows {
 public:
  PartRows() = default;
  /// So many parts of each sample.
  PartRows(std::span<Rgb> rows, std::size_t parts) : rows_(rows), parts_(parts) {}

  /// Whether they are not asked for.
  bool empty() const { return parts_ == 0; }
  std::span<Rgb> operator[](std::size_t sample) const { return rows_.subspan(sample * parts_, parts_); }
  PartRows part(std::size_t first, std::size_t size) const {
    return {rows_.subspan(first * parts_, size * parts_), parts_};
  }
  /// All rows, one after the other.
  std::span<Rgb> values() const { return rows_; }
  void clear() const { std::fill(rows_.begin(), rows_.end(), Rgb{}); }

 private:
  std::span<Rgb> rows_;
  std::size_t parts_ = 0;
};

/// Where the records of samples are written: the radiance of each, for each layer its values, in as many
/// channels as it has, and the parts of its light; none of what is not asked for, which then costs nothing.
class RecordSpans {
 public:
  RecordSpans() = default;
  /// The radiance alone.
  explicit RecordSpans(std::span<Rgb> color) : color_(color) {}

  std::span<Rgb> color() const { return color_; }
  std::span<Rgb>& operator[](Layer layer) { return columns_[std::size_t(layer)]; }
  std::span<Rgb> operator[](Layer layer) const { return columns_[std::size_t(layer)]; }
  PartRows& operator[](Division division) { return parts_[std::size_t(division)]; }
  const PartRows& operator[](Division division) const { return parts_[std::size_t(division)]; }
  bool has(Layer layer) const { return !columns_[std::size_t(layer)].empty(); }
  bool has(Division division) const { return !parts_[std::size_t(division)].empty(); }
  /// Whether any layer is asked for.
  bool has_layers() const {
    return std::any_of(columns_.begin(), columns_.end(), [](const auto& column) { return !column.empty(); });
  }
  /// Makes all radiance black, all layers blank, and all parts black.
  void clear() const {
    std::fill(color_.begin(), color_.end(), Rgb{});
    for (std::size_t i = 0; i < layer_count; ++i)
      if (!columns_[i].empty()) std::fill(columns_[i].begin(), columns_[i].end(), blank_record(Layer(i)));
    for (const PartRows& rows : parts_) rows.clear();
  }
  /// Multiplies one sample's radiance, its parts and what the film takes means of.
  void weigh(std::size_t sample, float weight) const {
    dim(sample, weight);
    for (std::size_t i = 0; i < layer_count; ++i)
      if (!columns_[i].empty() && layer_info(Layer(i)).gathering == Gathering::mean)
        columns_[i][sample] = columns_[i][sample] * weight;
  }
  /// Multiplies one sample's radiance and its parts alone.
  void dim(std::size_t sample, float factor) const {
    color_[sample] = color_[sample] * factor;
    for (const PartRows& rows : parts_)
      if (!rows.empty())
        for (Rgb& part : rows[sample]) part = part * factor;
  }
  /// Those of `size` samples from `first` on.
  RecordSpans part(std::size_t first, std::size_t size) const {
    RecordSpans part(color_.subspan(first, size));
    for (std::size_t i = 0; i < layer_count; ++i)
      if (!columns_[i].empty()) part.columns_[i] = columns_[i].subspan(first, size);
    for (const Division division : divisions)
      if (has(division)) part[division] = (*this)[division].part(first, size);
    return part;
  }

 private:
  std::span<Rgb> color_;
  std::array<std::span<Rgb>, layer_count> columns_;
  std::array<PartRows, divisions.size()> parts_;
};

/// The records of samples that are made together.
class Records {
 public:
  /// Room for `size` samples.
  Records(const FilmContents& contents, std::size_t size) : color_(size), part_counts_(contents.parts) {
    for (const Layer layer : contents.layers)
      if (layer_info(layer).gathering != Gathering::of_color) columns_[std::size_t(layer)].resize(size);
    for (std::size_t i = 0; i < parts_.size(); ++i) parts_[i].resize(size * part_counts_[i]);
  }
  /// Of the first `size` samples.
  RecordSpans spans(std::size_t size) {
    RecordSpans spans(std::span<Rgb>(color_).first(size));
    for (std::size_t i = 0; i < layer_count; ++i)
      if (!columns_[i].empty()) spans[Layer(i)] = std::span(columns_[i]).first(size);
    for (std::size_t i = 0; i < parts_.size(); ++i)
      spans[Division(i)] = {std::span(parts_[i]).first(size * part_counts_[i]), part_counts_[i]};
    return spans;
  }

 private:
  std::vector<Rgb> color_;
  std::array<std::vector<Rgb>, layer_count> columns_;
  PartCounts part_counts_;
  std::array<std::vector<Rgb>, divisions.size()> parts_;
};

}  // namespace twinray
