// SPDX-License-Identifier: Apache-2.0
// What scenes that tests write as glTF are made of.
#pragma once
#include <memory>

#include "core/geometry.h"
#include "core/mip_map.h"
#include "tests/support/graded_picture.h"

namespace twinray::test {

inline Mesh triangle() {
  Mesh mesh{.name = "triangle", .positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .triangles = {{0, 1, 2}}};
  mesh.uvs = {{0, 0}, {1, 0}, {0.25f, 1}};
  mesh.uv_indices = mesh.triangles;
  return mesh;
}

inline std::shared_ptr<const MipMap> picture() { return graded_picture(4, 2); }

}  // namespace twinray::test
