// SPDX-License-Identifier: Apache-2.0
#include "io/obj/lines.h"

#include <fmt/format.h>

#include <cstddef>

namespace twinray {

std::string obj_text(std::span<const LineObject> objects) {
  std::string text;
  std::size_t vertices = 0;  // Of the whole file; the first is number 1.
  for (const LineObject& object : objects) {
    text += fmt::format("o {}\n", object.name);
    for (const std::vector<Vec3>& line : object.lines) {
      for (const Vec3& point : line) text += fmt::format("v {} {} {}\n", point.x, point.y, point.z);
      text += "l";
      for (std::size_t i = 0; i < line.size(); ++i) text += fmt::format(" {}", ++vertices);
      text += "\n";
    }
  }
  return text;
}

}  // namespace twinray
