// SPDX-License-Identifier: Apache-2.0
// How CS184's program sees a scene, worked out anew from the description of its behaviour: with an XML reader
// of its own, in double, every triangle against every pixel that it may cover. It uses nothing of the
// project, so that the project's pictures can be held to it.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace twinray::test::cs184 {

/// The program's picture of normals, each pixel by the ray through its centre; rows from the top.
struct Picture {
  int width = 0, height = 0;
  std::vector<std::array<std::uint8_t, 3>> pixels;
  std::vector<bool> is_hit;
};

/// Of a COLLADA document with <matrix>, <translate>, <rotate> and <scale> nodes, meshes, CGL spheres and a
/// camera.
Picture normals_picture(const std::string& collada, int width, int height);

}  // namespace twinray::test::cs184
