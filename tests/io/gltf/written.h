// SPDX-License-Identifier: Apache-2.0
// What scenes that tests write as glTF are made of.
#pragma once
#include <memory>

#include "core/geometry.h"
#include "core/mip_map.h"

namespace twinray::test {

inline Mesh triangle() {
  Mesh mesh{.name = "triangle", .positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .triangles = {{0, 1, 2}}};
  mesh.uvs = {{0, 0}, {1, 0}, {0.25f, 1}};
  mesh.uv_indices = mesh.triangles;
  return mesh;
}

/// Of colours that bytes of sRGB have, about.
inline std::shared_ptr<const MipMap> picture() {
  Image image(4, 2);
  for (std::size_t i = 0; i < 8; ++i)
    image.pixels[i] = {0.1f * float(i), 0.05f * float(i) + 0.01f, 0.9f - 0.1f * float(i)};
  return std::make_shared<const MipMap>(std::move(image));
}

}  // namespace twinray::test
