// SPDX-License-Identifier: Apache-2.0
#include "check/ray_class.h"

#include <fmt/format.h>

#include <array>

#include "core/error.h"

namespace twinray {
namespace {

constexpr std::array<const char*, ray_class_count> class_names{
    "camera",  "shadow",  "bounce", "random",     "vertices", "edges", "axes",   "box faces",
    "grazing", "surface", "ends",   "directions", "far",      "moved", "shrunk", "grown"};
constexpr std::array<const char*, 4> placement_names{"file", "moved", "shrunk", "grown"};

}  // namespace

std::string ray_class_name(RayClass ray_class) { return class_names[std::size_t(ray_class)]; }

Placement placement_of(RayClass ray_class) {
  switch (ray_class) {
    case RayClass::moved:
      return Placement::moved;
    case RayClass::shrunk:
      return Placement::shrunk;
    case RayClass::grown:
      return Placement::grown;
    default:
      return Placement::file;
  }
}

std::string placement_name(Placement placement) { return placement_names[std::size_t(placement)]; }

Placement parse_placement(const std::string& name) {
  for (std::size_t i = 0; i < placement_names.size(); ++i)
    if (placement_names[i] == name) return Placement(i);
  throw Error(fmt::format("there is no placement \"{}\"; valid are file, moved, shrunk, grown", name));
}

}  // namespace twinray
