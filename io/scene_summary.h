// SPDX-License-Identifier: Apache-2.0
// What a reader understood of a scene file: for the user to check, since a wrong unit, axis or light shows
// late.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/scene.h"
#include "io/render_defaults.h"

namespace twinray {

struct LightSummary {
  std::string name;
  std::string kind;      ///< "mesh, one side", "sphere", "point", ...
  std::string quantity;  ///< What `amount` is: "radiance", "intensity", "irradiance".
  Rgb amount;
  /// Of mesh and sphere lights, in radiance x scene units squared, and of points and spots whose light falls
  /// off as 1/d^2; 0 for the others.
  Rgb power;
};

/// From the first moment that a file's animations say something of to the last, in seconds.
struct AnimationSummary {
  double first = 0, last = 0;
  std::optional<double> shown;     ///< The moment that is shown; none: all at rest.
  std::optional<Shutter> shutter;  ///< In place of one moment: all that the picture is to show.
};

struct SceneSummary {
  std::string unit_name = "meter";   ///< "" of a format that has neither units nor an axis that is up.
  double unit_meters = 1;            ///< Coordinates stay in this unit.
  char up_axis = 'Y';                ///< Of the file: X, Y or Z. The scene itself has Y up.
  std::string camera;                ///< Its name; "" where the file has none and a default one was made.
  std::vector<std::string> cameras;  ///< The names of all cameras of the scene.
  std::optional<AnimationSummary> animation;  ///< None where nothing moves.
  std::size_t meshes = 0, triangles = 0, dropped_triangles = 0, spheres = 0, materials = 0;
  std::size_t prototypes = 0, instances = 0;  ///< The shapes of prototypes count once above.
  std::uint64_t seen_primitives = 0;          ///< Triangles and spheres, as often as instances show them.
  std::size_t repeated = 0;                   ///< What the file shows more than once, as instances or copies.
  bool has_double_lamps = false;              ///< One of two was left out, or would be (io/collada/lamp.h).
  std::vector<LightSummary> lights;
  std::vector<std::string> notes;  ///< Decisions of the reader, such as the one-lamp rule.
};

/// Counts the scene's shapes, materials and lights into the summary.
void count_scene(const Scene& scene, SceneSummary& summary);

/// The summary as lines of text, without line ends.
std::vector<std::string> summary_lines(const SceneSummary& summary);

}  // namespace twinray
