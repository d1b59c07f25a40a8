// SPDX-License-Identifier: Apache-2.0
// Scenes that are written to a file and read again, and what of them must be the same.
#pragma once
#include <string>
#include <vector>

#include "core/scene.h"
#include "io/load_options.h"
#include "tests/support/json.h"

namespace twinray::test {

struct RoundTrip {
  Scene scene;                        ///< As it was read.
  std::string text;                   ///< Of the file.
  std::vector<std::string> warnings;  ///< Of the writer, without the file's name.
};

/// Writes a scene to a file of this name ("a.pbrt") in a folder of its own, for a picture of 480 x 360, and
/// reads it with each of its instances. Throws Error; also where the reader has a warning.
RoundTrip round_trip(const Scene& scene, const std::string& name, LoadOptions options = {});

/// A scene of one shape.
Scene scene_of(Shape shape, const SurfaceModel& model);
/// The material of the first shape that came back.
const Material& only_material(const RoundTrip& trip);

/// How far the corners of triangles of two scenes are apart at most, in the order of shapes and triangles.
struct GeometryDifference {
  std::string fault;  ///< Why they cannot be compared: other shapes or numbers of triangles. Or empty.
  float positions = 0, normals = 0, uvs = 0;  ///< 0: the same bits. Normals may point to the other side.
  bool has_lost_uvs = false;                  ///< The second one lacks some texture coordinates.
};
GeometryDifference difference(const Scene& a, const Scene& b);

/// What each shape is made of, and what it emits: the entries of the exchange form, without names.
nlohmann::json surfaces(const Scene& scene);
/// The lights that are no shapes, in the same form.
nlohmann::json free_lights(const Scene& scene);
/// Where two such trees differ by more than a part of the larger number, as a pointer; empty where nowhere.
std::string first_difference(const nlohmann::json& a, const nlohmann::json& b, double tolerance);

/// The largest difference of the directions and origins of rays through some points of the frame of a picture
/// of 480 x 360.
float difference(const Camera& a, const Camera& b);

}  // namespace twinray::test
