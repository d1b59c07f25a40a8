// SPDX-License-Identifier: Apache-2.0
// Private: the mesh of an object of 3MF, divided by what its triangles wear.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/geometry.h"
#include "io/three_mf/properties.h"

namespace twinray {

/// Triangles that look alike.
struct ThreeMfPiece {
  Mesh mesh;
  std::optional<ThreeMfProperty> property;  ///< Of all of them; none where they have none or `colors`.
  std::vector<Rgb> colors;  ///< Of each vertex, where the corners of a triangle have different ones.
};

/// What an object gives its triangles.
struct ThreeMfDefault {
  std::optional<ThreeMfProperty> property;  ///< Of those that name nothing themselves.
  std::optional<std::uint32_t> group = {};  ///< Of those that name a number alone: the object's own group.
};

/// Reads <mesh>. Throws Error, with the place, where a vertex is not three numbers, or a triangle's index is
/// out of range.
std::vector<ThreeMfPiece> read_pieces(const XmlElement& mesh, const std::string& name,
                                      const ThreeMfProperties& properties, const ThreeMfDefault& own);

}  // namespace twinray
