// SPDX-License-Identifier: Apache-2.0
#include "core/film.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <span>
#include <string>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "core/columns.h"
#include "core/error.h"

namespace twinray {
namespace {

/// In double, so that the variance of a constant pixel is 0 up to a double's rounding.
double wide_luminance(double r, double g, double b) { return 0.2126 * r + 0.7152 * g + 0.0722 * b; }

bool in_range(float x) { return std::fabs(x) <= Film::max_value; }  // A NaN is not.

bool in_range(const Rgb& color) { return in_range(color.r) && in_range(color.g) && in_range(color.b); }

/// Adds colours that are all in range.
void add_colors(PixelSums& sums, std::span<const Rgb> colors) {
  sums.r.add_units(fixed_units(colors, &Rgb::r));
  sums.g.add_units(fixed_units(colors, &Rgb::g));
  sums.b.add_units(fixed_units(colors, &Rgb::b));
  FixedSquareSum squared;
  for (const Rgb& color : colors) squared.add_square_of(wide_luminance(color.r, color.g, color.b));
  sums.luminance_squared += squared;
  sums.count += std::uint32_t(colors.size());
}

}  // namespace

Rgb PixelSums::mean() const {
  if (count == 0) return {};
  return {float(r.value() / count), float(g.value() / count), float(b.value() / count)};
}

double PixelSums::luminance_mean() const {
  return count == 0 ? 0 : wide_luminance(r.value(), g.value(), b.value()) / count;
}

double PixelSums::luminance_variance() const {
  if (count < 2) return 0;
  const double sum = wide_luminance(r.value(), g.value(), b.value());
  return std::max(0.0, (luminance_squared.value() - sum * (sum / count)) / (count - 1));
}

PixelSums& PixelSums::operator+=(const PixelSums& other) {
  r += other.r;
  g += other.g;
  b += other.b;
  luminance_squared += other.luminance_squared;
  count += other.count;
  if (other.rejected > 0)
    rejected_index = rejected == 0 ? other.rejected_index : std::min(rejected_index, other.rejected_index);
  rejected += other.rejected;
  return *this;
}

void PixelSums::reject(std::uint32_t sample_index) {
  rejected_index = rejected == 0 ? sample_index : std::min(rejected_index, sample_index);
  ++rejected;
}

Film::LayerPixels Film::make_pixels(Layer layer, std::size_t pixels) {
  switch (layer_info(layer).gathering) {
    case Gathering::mean:
      return MeanPixels(pixels, channel_count(layer));
    case Gathering::first:
      return FirstPixels(pixels, channel_count(layer));
    case Gathering::coverage:
      return CoveragePixels(pixels);
    case Gathering::of_color:
      break;
  }
  return {};
}

Film::Film(int frame_width, int frame_height, PixelRect window, FilmContents contents)
    : frame_width_(frame_width),
      frame_height_(frame_height),
      window_(window),
      contents_(std::move(contents)) {
  constexpr int largest = 65536;
  if (frame_width < 1 || frame_width > largest || frame_height < 1 || frame_height > largest)
    throw Error(fmt::format("a frame of {} x {} pixels: each side must lie in 1 to {}", frame_width,
                            frame_height, largest));
  const bool is_near = window.x0 >= -largest && window.y0 >= -largest && window.x1 <= frame_width + largest &&
                       window.y1 <= frame_height + largest;
  if (!is_near || window.x0 >= window.x1 || window.y0 >= window.y1)
    throw Error(
        fmt::format("the window x {} to {}, y {} to {} is empty, or reaches more than {} pixels beyond the "
                    "frame of {} x {}",
                    window.x0, window.x1, window.y0, window.y1, largest, frame_width, frame_height));
  const std::size_t count = std::size_t(window.width()) * std::size_t(window.height());
  pixels_.resize(count);
  for (const Layer layer : layers()) layer_pixels_.push_back(make_pixels(layer, count));
  for (const std::size_t parts : contents_.parts) part_pixels_.emplace_back(count, parts);
}

std::size_t Film::offset(int x, int y) const {
  assert(x >= window_.x0 && x < window_.x1 && y >= window_.y0 && y < window_.y1);
  return std::size_t(y - window_.y0) * std::size_t(window_.width()) + std::size_t(x - window_.x0);
}

bool Film::add(int x, int y, std::uint32_t sample_index, const RecordSpans& records, std::size_t record) {
  add(x, y, sample_index, records, record, 1);
  return in_range(records.color()[record]);
}

void Film::add(int x, int y, std::uint32_t first_index, const RecordSpans& records, std::size_t record,
               std::size_t count) {
  const std::size_t pixel = offset(x, y);
  PixelSums& sums = pixels_[pixel];
  assert(sums.count + sums.rejected + count <= max_samples);
  const std::span<const Rgb> colors = records.color().subspan(record, count);
  for (std::size_t begin = 0, end; begin < count; begin = end) {
    end = begin;
    while (end < count && in_range(colors[end])) ++end;
    const std::uint32_t first = first_index + std::uint32_t(begin);
    if (end > begin) {
      add_colors(sums, colors.subspan(begin, end - begin));
      add_layers(pixel, first, records, record + begin, end - begin);
    } else {
      sums.reject(first);
      ++end;
    }
  }
}

void Film::add_layers(std::size_t pixel, std::uint32_t first_index, const RecordSpans& records,
                      std::size_t record, std::size_t count) {
  for (std::size_t layer = 0; layer < layer_pixels_.size(); ++layer) {
    const auto column = records[layers()[layer]];
    if (column.empty()) continue;
    const auto values = column.subspan(record, count);
    if (auto* const mean = std::get_if<MeanPixels>(&layer_pixels_[layer])) mean->add(pixel, values);
    if (auto* const first = std::get_if<FirstPixels>(&layer_pixels_[layer]))
      for (std::size_t i = 0; i < count; ++i) first->add(pixel, first_index + std::uint32_t(i), values[i]);
    if (auto* const covered = std::get_if<CoveragePixels>(&layer_pixels_[layer]))
      for (const Rgb& value : values) covered->add(pixel, {recorded_id(value), 1});
  }
  for (const Division division : divisions)
    if (const PartRows& rows = records[division]; !rows.empty())
      part_pixels_[std::size_t(division)].add(pixel, rows.part(record, count).values());
}

Rgb Film::value(std::size_t layer, int x, int y) const {
  const std::size_t pixel = offset(x, y);
  const PixelSums& sums = pixels_[pixel];
  if (const auto* const mean = std::get_if<MeanPixels>(&layer_pixels_[layer]))
    return mean->mean(pixel, sums.count);
  if (const auto* const first = std::get_if<FirstPixels>(&layer_pixels_[layer])) {
    const float nothing = layer_info(layers()[layer]).nothing;
    return first->has(pixel) ? first->value(pixel) : Rgb{nothing, nothing, nothing};
  }
  if (layers()[layer] == Layer::samples) return {float(sums.count), 0, 0};
  if (layers()[layer] != Layer::variance || sums.count == 0) return {};
  return {float(sums.luminance_variance() / sums.count), 0, 0};
}

std::vector<Coverage> Film::coverage(std::size_t layer, int x, int y) const {
  return std::get<CoveragePixels>(layer_pixels_[layer]).at(offset(x, y));
}

void Film::read_parts(Division division, int x, int y, std::span<Rgb> parts) const {
  const PixelSums& sums = pixel(x, y);
  part_pixels_[std::size_t(division)].read(offset(x, y), sums.count, sums.mean(), parts);
}

std::uint64_t Film::bytes(std::uint64_t pixels, const FilmContents& contents) {
  std::uint64_t bytes = sizeof(PixelSums);
  for (const Layer layer : contents.layers) {
    const Gathering gathering = layer_info(layer).gathering;
    if (gathering == Gathering::mean) bytes += MeanPixels::bytes(channel_count(layer));
    if (gathering == Gathering::first) bytes += FirstPixels::bytes(channel_count(layer));
    if (gathering == Gathering::coverage) bytes += CoveragePixels::bytes;
  }
  for (const std::size_t parts : contents.parts) bytes += PartPixels::bytes(parts);
  return pixels * bytes;
}

std::uint64_t Film::rejected_count() const {
  std::uint64_t sum = 0;
  for (const PixelSums& sums : pixels_) sum += sums.rejected;
  return sum;
}

RejectedSample Film::first_rejected() const {
  for (int y = window_.y0; y < window_.y1; ++y)
    for (int x = window_.x0; x < window_.x1; ++x)
      if (const PixelSums& sums = pixel(x, y); sums.rejected > 0) return {x, y, sums.rejected_index};
  return {};
}

namespace {

std::string names_of(const FilmContents& contents) {
  std::string names = "color";
  for (const Layer layer : contents.layers) names += fmt::format(", {}", layer_info(layer).name);
  const auto& [paths, groups] = contents.parts;
  if (paths > 0) names += fmt::format(", light by {} paths", paths);
  if (groups > 0) names += fmt::format(", light by {} groups", groups);
  return names;
}

}  // namespace

void Film::check_mergeable(const Film& other) const {
  if (other.frame_width_ != frame_width_ || other.frame_height_ != frame_height_)
    throw Error(fmt::format("films of different frames cannot be merged: {} x {} and {} x {} pixels",
                            frame_width_, frame_height_, other.frame_width_, other.frame_height_));
  if (other.contents_ != contents_)
    throw Error(fmt::format("films of different layers cannot be merged: {} and {}", names_of(contents_),
                            names_of(other.contents_)));
  const PixelRect& a = window_;
  const PixelRect& b = other.window_;
  if (b.x0 < a.x0 || b.y0 < a.y0 || b.x1 > a.x1 || b.y1 > a.y1)
    throw Error(fmt::format(
        "the window x {} to {}, y {} to {} cannot be merged into the smaller x {} to {}, y {} to {}", b.x0,
        b.x1, b.y0, b.y1, a.x0, a.x1, a.y0, a.y1));
  other.for_each_pixel([&](int x, int y) {
    const PixelSums &own = pixel(x, y), &sums = other.pixel(x, y);
    if (std::uint64_t(own.count) + own.rejected + sums.count + sums.rejected > max_samples)
      throw Error(fmt::format("merged, pixel ({}, {}) has more than {} samples", x, y, max_samples));
  });
}

void Film::merge_layer(LayerPixels& own, const LayerPixels& other, std::size_t to, std::size_t from) {
  if (auto* const mean = std::get_if<MeanPixels>(&own)) mean->merge(to, std::get<MeanPixels>(other), from);
  if (auto* const first = std::get_if<FirstPixels>(&own))
    first->merge(to, std::get<FirstPixels>(other), from);
  if (auto* const covered = std::get_if<CoveragePixels>(&own))
    covered->merge(to, std::get<CoveragePixels>(other), from);
}

void Film::merge(const Film& other) {
  check_mergeable(other);
  other.for_each_pixel([&](int x, int y) {
    const std::size_t to = offset(x, y), from = other.offset(x, y);
    pixels_[to] += other.pixels_[from];
    for (std::size_t layer = 0; layer < layer_pixels_.size(); ++layer)
      merge_layer(layer_pixels_[layer], other.layer_pixels_[layer], to, from);
    for (std::size_t i = 0; i < part_pixels_.size(); ++i)
      part_pixels_[i].merge(to, other.part_pixels_[i], from);
  });
}

namespace {

/// Calls visit() with the layer as what it is; not for one that the colours say.
template <typename LayerPixels, typename Visit>
void visit_kept(LayerPixels& layer, const Visit& visit) {
  std::visit(
      [&](auto& pixels) {
        if constexpr (!std::is_same_v<std::remove_cvref_t<decltype(pixels)>, std::monostate>) visit(pixels);
      },
      layer);
}

}  // namespace

void Film::save(int y0, int y1, ColumnWriter& to) const {
  const std::size_t begin = offset(window_.x0, y0),
                    end = begin + std::size_t(y1 - y0) * std::size_t(window_.width());
  to.put(std::span(pixels_).subspan(begin, end - begin));
  for (const LayerPixels& layer : layer_pixels_)
    visit_kept(layer, [&](const auto& pixels) { pixels.save(begin, end, to); });
  for (const PartPixels& parts : part_pixels_) parts.save(begin, end, to);
}

void Film::load(ColumnReader& from) {
  from.take(std::span(pixels_));
  for (const PixelSums& sums : pixels_)
    if (std::uint64_t(sums.count) + sums.rejected > max_samples)
      throw Error(fmt::format("a pixel has more than {} samples", max_samples));
  for (LayerPixels& layer : layer_pixels_) visit_kept(layer, [&](auto& pixels) { pixels.load(from); });
  for (PartPixels& parts : part_pixels_) parts.load(from);
}

}  // namespace twinray
