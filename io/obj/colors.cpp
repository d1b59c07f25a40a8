// SPDX-License-Identifier: Apache-2.0
#include "io/obj/colors.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

#include "io/picture/srgb.h"

namespace twinray {
namespace {

constexpr Rgb no_color{-std::numeric_limits<float>::infinity(), 0, 0};
constexpr std::size_t painted_digits = 8;  ///< Of a vertex, in a line of ZBrush.

/// Puts a color at an index, behind as many absent ones as it takes.
void put(std::vector<Rgb>& colors, std::size_t index, const Rgb& color) {
  if (colors.size() <= index) colors.resize(index + 1, no_color);
  colors[index] = color;
}

bool has(const std::vector<Rgb>& colors, std::size_t index) {
  return index < colors.size() && !(colors[index] == no_color);
}

Rgb linear(const Rgb& color, float largest) {
  const Rgb encoded = within_unit(color / largest);
  return {decode_srgb(encoded.r), decode_srgb(encoded.g), decode_srgb(encoded.b)};
}

}  // namespace

bool ObjColors::add_vertex(std::size_t index, const ObjNumbers& numbers) {
  take_block(index);
  if (numbers.count < 6 || numbers.count > 7 || !numbers.end.empty()) return false;
  const auto& values = numbers.values;
  put(numbers_, index, {values[3], values[4], values[5]});
  for (const float value : {values[3], values[4], values[5]}) {
    largest_ = std::max(largest_, value);
    are_whole_ = are_whole_ && std::floor(value) == value;
  }
  has_alphas_ = has_alphas_ || numbers.count == 7;
  return true;
}

void ObjColors::add_painted(std::string_view line) {
  take_word(line = line.substr(1));
  for (std::string_view word; !(word = take_word(line)).empty();)
    for (; word.size() >= painted_digits; word.remove_prefix(painted_digits)) {
      std::uint32_t value = 0;
      const auto [end, error] = std::from_chars(word.data(), word.data() + painted_digits, value, 16);
      if (error != std::errc{} || end != word.data() + painted_digits) return;
      block_.push_back({float(value >> 16 & 255), float(value >> 8 & 255), float(value & 255)});
    }
}

/// Gives the colors since the last vertex to the last of `count` vertices.
void ObjColors::take_block(std::size_t count) {
  const std::size_t taken = std::min(block_.size(), count);
  beyond_ += block_.size() - taken;
  for (std::size_t i = 0; i < taken; ++i) put(painted_, count - taken + i, block_[i]);
  block_.clear();
}

std::vector<Rgb> ObjColors::take(std::size_t count, std::vector<std::string>& notes) {
  take_block(count);
  if (has_alphas_) notes.push_back("alphas of vertices, behind their colors, are left out");
  if (beyond_ > 0) notes.push_back(fmt::format("colors (\"#MRGB\") of no vertex, left out: {}", beyond_));
  if (are_bytes())
    notes.push_back(
        fmt::format("colors of vertices are taken for bytes: the largest number is {:g}", largest_));
  const float most = are_bytes() ? 255 : 1;
  if (largest_ > most)
    notes.push_back(fmt::format("colors of vertices above {:g} are taken as {:g}", most, most));
  if (numbers_.empty() && painted_.empty()) return {};
  std::vector<Rgb> colors(count, white);
  for (std::size_t i = 0; i < count; ++i)
    if (has(numbers_, i))
      colors[i] = linear(numbers_[i], most);
    else if (has(painted_, i))
      colors[i] = linear(painted_[i], 255);
  return colors;
}

}  // namespace twinray
