// SPDX-License-Identifier: Apache-2.0
// A picture's light may be divided into parts that add up to it: by the paths that it took, or by the groups
// of lights that it came from.
#pragma once
#include <array>
#include <cstddef>

namespace twinray {

enum class Division : std::size_t {
  paths,   ///< Into one part for each LightPath.
  groups,  ///< Into one for each of Scene::light_groups.
};
inline constexpr std::array divisions{Division::paths, Division::groups};

/// How many parts each division has; 0 where it is not asked for.
using PartCounts = std::array<std::size_t, divisions.size()>;

/// The way that light took (integrators/light_paths.h).
enum class LightPath : std::size_t {
  emission,     ///< What the camera sees directly.
  environment,  ///< Seen directly behind all.
  diffuse_direct,
  diffuse_indirect,
  glossy_direct,
  glossy_indirect,
  transmission_direct,
  transmission_indirect,
};
inline constexpr std::size_t light_path_count = 8;
/// As files name it.
const char* light_path_name(LightPath path);

}  // namespace twinray
