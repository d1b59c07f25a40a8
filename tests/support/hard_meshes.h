// SPDX-License-Identifier: Apache-2.0
// Meshes that are hard on ray engines.
#pragma once
#include <utility>
#include <vector>

#include "tests/support/shapes.h"

namespace twinray::test {

/// Slivers whose width is 10^-5 of their length.
inline Mesh slivers() {
  Random random(21);
  Mesh mesh{.name = "slivers"};
  for (int i = 0; i < 300; ++i) {
    const Vec3 a = random.in_cube(), along = random.in_cube(), across = random.in_cube(1e-5f);
    add_triangle(mesh, a, a + along, a + along * 0.5f + across);
  }
  return mesh;
}

/// Three layers of a grid, each twice over.
inline Mesh layers() {
  Mesh mesh{.name = "layers"};
  for (int layer = 0; layer < 6; ++layer)
    for (int i = 0; i < 8; ++i)
      for (int j = 0; j < 8; ++j) {
        const float x = float(i), y = float(j), z = float(layer / 2);
        add_triangle(mesh, {x, y, z}, {x + 1, y, z}, {x, y + 1, z});
        add_triangle(mesh, {x + 1, y, z}, {x + 1, y + 1, z}, {x, y + 1, z});
      }
  return mesh;
}

/// Points, lines and triangles without area among others.
inline Mesh with_degenerate() {
  Mesh mesh = soup(200, 0.4f, 31);
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 4) {
    mesh.triangles[i][1] = mesh.triangles[i][0];
    if (i % 8 == 0) mesh.triangles[i][2] = mesh.triangles[i][0];
  }
  return mesh;
}

/// One in a hundred lies anywhere up to 10^7 away.
inline Mesh with_thrown_vertices() {
  Mesh mesh = soup(300, 0.3f, 71);
  Random random(72);
  for (Vec3& p : mesh.positions)
    if (random.below(100) == 0) p = random.in_cube(1e7f);
  return mesh;
}

/// A sphere so far from the origin of coordinates that its edges are a few hundred floats long.
inline Mesh far_sphere() {
  Mesh mesh = icosphere_mesh(4);
  for (Vec3& p : mesh.positions) p = p + Vec3{20000, -3000, 7000};
  drop_degenerate_triangles(mesh);
  return mesh;
}

/// One triangle a million times as large as the others.
inline Mesh huge_among_tiny() {
  Mesh mesh = soup(300, 1e-3f, 41);
  add_triangle(mesh, {-1e4f, -1e4f, 0.1f}, {1e4f, -1e4f, 0.2f}, {0, 1e4f, 0.3f});
  return mesh;
}

/// All of these, a closed sphere, and a soup.
inline std::vector<Mesh> hard_meshes() {
  return {icosphere_mesh(4), soup(400, 0.3f, 1), slivers(),         layers(),
          with_degenerate(), far_sphere(),       huge_among_tiny(), with_thrown_vertices()};
}

}  // namespace twinray::test
