// SPDX-License-Identifier: Apache-2.0
#include "io/picture/environment_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/error.h"
#include "core/memory.h"
#include "core/radiance.h"
#include "io/picture/image_file.h"

namespace twinray {
namespace {

bool is_valid(float x) { return x >= 0 && x <= max_radiance; }  // A NaN is not.
bool is_radiance(const Rgb& c) { return is_valid(c.r) && is_valid(c.g) && is_valid(c.b); }

/// A picture in its frame: black around, and without what lies outside.
Image framed(const Image& image, const ImageFrame& frame) {
  Image whole(frame.width, frame.height);
  const auto end = [](int begin, int size, int most) {
    return int(std::min(std::int64_t(begin) + size, std::int64_t(most)));
  };
  for (int y = std::max(0, frame.y); y < end(frame.y, image.height, frame.height); ++y)
    for (int x = std::max(0, frame.x); x < end(frame.x, image.width, frame.width); ++x)
      whole.at(x, y) = image.at(x - frame.x, y - frame.y);
  return whole;
}

/// The picture, where it is a part of a frame around all directions with that frame.
Image read_map(const std::string& path) {
  Image image = read_image(path);
  const std::optional<ImageFrame> frame = read_frame(path);
  if (!frame ||
      (frame->x == 0 && frame->y == 0 && frame->width == image.width && frame->height == image.height))
    return image;
  constexpr std::int64_t most_pixels = std::int64_t(1) << 28;
  if (std::int64_t(frame->width) * frame->height > most_pixels || frame->width < 1 || frame->height < 1)
    throw Error(fmt::format("{}: its frame has {} x {} pixels; valid are up to 2^28", path, frame->width,
                            frame->height));
  const MemoryNeed need{
      fmt::format("the {} x {} pixels of the frame of {}", frame->width, frame->height, path),
      std::uint64_t(frame->width) * std::uint64_t(frame->height) * sizeof(Rgb)};
  check_memory({&need, 1});
  return framed(image, *frame);
}

}  // namespace

LoadedEnvironment load_environment(const std::string& path) {
  LoadedEnvironment loaded{read_map(path), {}};
  Image& map = loaded.map;
  std::size_t count = 0, first = 0;
  for (std::size_t i = 0; i < map.pixels.size(); ++i) {
    if (is_radiance(map.pixels[i])) continue;
    if (count++ == 0) first = i;
  }
  if (count == 0) return loaded;
  const Rgb value = map.pixels[first];
  const std::size_t width = std::size_t(map.width);
  loaded.fault = fmt::format(
      "{}: {} of {} x {} pixels {} not radiance, the first at column {}, row {} (from 0): ({:g}, {:g}, "
      "{:g}); "
      "each component must lie in [0, {:g}]",
      path, count, map.width, map.height, count == 1 ? "is" : "are", first % width, first / width, value.r,
      value.g, value.b, max_radiance);
  for (Rgb& pixel : map.pixels)
    if (!is_radiance(pixel)) pixel = {};
  return loaded;
}

}  // namespace twinray
