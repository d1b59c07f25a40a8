// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/area_vector.h"
#include "core/geometry.h"

namespace twinray {

/// Of a triangle of the mesh: out of its front.
inline AreaVector area_vector(const Mesh& mesh, const Triangle& triangle) {
  const auto& [a, b, c] = triangle;
  return {mesh.positions[a], mesh.positions[b], mesh.positions[c]};
}

}  // namespace twinray
