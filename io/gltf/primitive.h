// SPDX-License-Identifier: Apache-2.0
// One primitive of a glTF mesh: its vertices and triangles, in the mesh's own space.
#pragma once
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/geometry.h"
#include "io/gltf/accessor.h"

namespace twinray {

struct GltfPrimitive {
  std::string pointer;  ///< "/meshes/3/primitives/0"
  int mesh = 0, index = 0;
  int material = -1;  ///< -1: the format's default one.
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
  std::vector<Vec3> normals;             ///< One for each position, or none.
  std::map<int, std::vector<Vec2>> uvs;  ///< By the number of their set: one for each position.
  std::vector<float> handedness;         ///< The sign of the tangents, +-1: one for each position, or none.
  std::set<int> turned_uvs;              ///< The sets of which the tangents are not those.
  GltfNumbers colors;                    ///< COLOR_0: three or four a position, or none.
  /// Of a mesh that Draco packs, what is needed later: JOINTS_n and WEIGHTS_n, by their names.
  std::map<std::string, GltfNumbers> unpacked;
};

/// Reads a primitive. Nothing where it is of points or lines, or has no positions, which a warning says.
/// Throws Error, with the place, where counts differ or an index is out of range.
std::optional<GltfPrimitive> read_primitive(GltfDocument& document, int mesh, int primitive);

}  // namespace twinray
