// SPDX-License-Identifier: Apache-2.0
// Closed meshes for tests, about the origin and within [-1, 1]^3; fronts outside.
#pragma once
#include <cmath>
#include <map>
#include <utility>

#include "core/geometry.h"

namespace twinray::test {

inline Mesh box_mesh() {
  Mesh mesh{.name = "box"};
  for (int i = 0; i < 8; ++i)
    mesh.positions.push_back({i & 1 ? 1.0f : -1.0f, i & 2 ? 1.0f : -1.0f, i & 4 ? 1.0f : -1.0f});
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

/// A regular tetrahedron: its faces meet at 70.5 degrees.
inline Mesh tetrahedron_mesh() {
  return {.name = "tetrahedron",
          .positions = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
          .triangles = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
}

/// Each triangle divided in four, `levels` times; shared edges stay shared.
inline Mesh subdivided(Mesh mesh, int levels) {
  for (; levels > 0; --levels) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [at, is_new] =
          middles.try_emplace({std::min(a, b), std::max(a, b)}, std::uint32_t(mesh.positions.size()));
      if (is_new) mesh.positions.push_back(mesh.positions[a] * 0.5f + mesh.positions[b] * 0.5f);
      return at->second;
    };
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : mesh.triangles) {
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      for (const Triangle& t :
           {Triangle{a, ab, ca}, Triangle{ab, b, bc}, Triangle{ca, bc, c}, Triangle{ab, bc, ca}})
        finer.push_back(t);
    }
    mesh.triangles = std::move(finer);
  }
  return mesh;
}

/// A sphere of 8 * 4^levels triangles.
inline Mesh icosphere_mesh(int levels) {
  Mesh mesh{
      .name = "icosphere",
      .positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
      .triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
  mesh = subdivided(std::move(mesh), levels);
  for (Vec3& p : mesh.positions) p = normalize(p);
  return mesh;
}

/// Spikes and hollows: a sphere whose every `period`-th vertex stands out of the others.
inline Mesh star_mesh(int levels, int period) {
  Mesh mesh = icosphere_mesh(levels);
  mesh.name = "star";
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    if (i % std::size_t(period) != 0) mesh.positions[i] = mesh.positions[i] * 0.4f;
  return mesh;
}

/// Turned about an oblique axis (so that no face is parallel to an axis plane), scaled, then moved.
inline Mesh placed(Mesh mesh, float scale, const Vec3& shift, bool is_turned) {
  // The rows of a rotation with rational entries: exact up to the rounding of each.
  const Vec3 x{2 / 7.0f, 3 / 7.0f, 6 / 7.0f}, y{-6 / 7.0f, -2 / 7.0f, 3 / 7.0f},
      z{3 / 7.0f, -6 / 7.0f, 2 / 7.0f};
  for (Vec3& p : mesh.positions) {
    if (is_turned) p = {dot(x, p), dot(y, p), dot(z, p)};
    p = p * scale + shift;
  }
  return mesh;
}

}  // namespace twinray::test
