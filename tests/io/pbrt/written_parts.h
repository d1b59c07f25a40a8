// SPDX-License-Identifier: Apache-2.0
// What tests of written scenes are made of.
#pragma once
#include <cmath>
#include <memory>

#include "core/scene.h"
#include "core/texture.h"
#include "tests/support/graded_picture.h"

namespace twinray::test {

/// Of a number whose text is exact, after a product with a rotation.
inline constexpr float rounding = 1e-6f;

inline Mesh plain_triangle() {
  return {.name = "triangle", .positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .triangles = {{0, 1, 2}}};
}
inline Mesh mapped_triangle() {
  Mesh mesh = plain_triangle();
  mesh.uvs = {{0.25f, 0.1f}, {3, -0.7f}, {0.3f, 0.9f}};
  mesh.uv_indices = mesh.triangles;
  return mesh;
}

inline std::shared_ptr<const MipMap> odd_picture() { return graded_picture(3, 2); }

/// Whether two textures give the same values where a grid of points lies.
inline bool are_alike(const Scene& a, std::uint32_t texture, const Scene& b, std::uint32_t other,
                      bool red_alone) {
  for (int i = 0; i < 81; ++i) {
    const TexturePoint at{.uv = {0.37f * float(i % 9) - 1, 0.29f * float(i / 9) - 1},
                          .is_smooth = true,
                          .position = {0.31f * float(i % 7) - 1.2f, 0.43f * float(i / 7), 0.1f * float(i)},
                          .normal = {0, 0.6f, i % 2 == 0 ? 0.8f : -0.8f},
                          .width = 0.01f};
    const Rgb x = evaluate(a.textures, texture, at), y = evaluate(b.textures, other, at);
    const float apart =
        red_alone ? std::fabs(x.r - y.r)
                  : max_component({std::fabs(x.r - y.r), std::fabs(x.g - y.g), std::fabs(x.b - y.b)});
    if (!(apart <= rounding)) return false;
  }
  return true;
}

}  // namespace twinray::test
