// SPDX-License-Identifier: Apache-2.0
// Scenes made in code, of any size: nothing to download, the same bits on every machine. Lengths are metres,
// +y is up.
#pragma once
#include <cstddef>
#include <span>
#include <string_view>

#include "core/scene.h"

namespace twinray::generated {

/// How many triangles the scenes have at least: the room's furniture alone takes more than 42,000.
inline constexpr std::size_t least_room = 50'000, least_ball = 1'000, least_forest = 10'000;
/// The most that any may have; of a scene of instances, how many of these.
inline constexpr std::size_t most_triangles = std::size_t(1) << 28;

/// A furnished room, closed all around, lit through blinds and by a lamp: huge walls and hair-thin pile,
/// slats, chairs, a draped cloth, curtains, books, thousands of little facets on balls. At least `least_room`
/// triangles.
Scene make_room(std::size_t triangles);

/// A sphere in a closed box, displaced by fractal noise: triangles of equal size, all over one surface. At
/// least `least_ball` of them.
Scene make_ball(std::size_t triangles);

/// Trees and grass on rough ground under a sky: leaves and blades that overlap without order, in a forest
/// that grows with its size. At least `least_forest` triangles.
Scene make_forest(std::size_t triangles);

/// A wood of instances of a dozen plants of 600 to 10,000 triangles.
Scene make_woods(std::size_t instances);

/// The stands of a stadium, a half of them mirrored: about as many instances, of seats of 370 triangles and
/// of steps.
Scene make_stadium(std::size_t instances);

/// A maker of scenes, and the size that benchmarks take where none is asked for.
struct GeneratedScene {
  const char* name;
  std::size_t size;   ///< In triangles; of a scene of instances, in these.
  std::size_t least;  ///< The smallest size.
  /// Gives that many triangles, within 2 %; throws Error for fewer than the least, or more than
  /// most_triangles.
  Scene (*make)(std::size_t size);
};

/// Those of triangles alone,
std::span<const GeneratedScene> generated_scenes();
/// and those of instances.
std::span<const GeneratedScene> instanced_scenes();

/// Whether a scene's name stands for a generated one: it begins with "generated:".
bool is_generated(std::string_view name);

/// The scene of a name such as "generated:ball", or "generated:forest:1000000" for that many triangles, or
/// "generated:woods:10000" for that many instances.
/// Throws Error that lists the valid names.
Scene make_generated(std::string_view name);

}  // namespace twinray::generated
