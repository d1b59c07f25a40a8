// SPDX-License-Identifier: Apache-2.0
#include "io/picture/environment_file.h"

#include <fmt/format.h>

#include <cstddef>

#include "core/radiance.h"
#include "io/picture/image_file.h"

namespace twinray {
namespace {

bool is_valid(float x) { return x >= 0 && x <= max_radiance; }  // A NaN is not.
bool is_radiance(const Rgb& c) { return is_valid(c.r) && is_valid(c.g) && is_valid(c.b); }

}  // namespace

LoadedEnvironment load_environment(const std::string& path) {
  LoadedEnvironment loaded{read_framed_image(path), {}, unread_parts(path)};
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
