// SPDX-License-Identifier: Apache-2.0
// Geometry and rays for tests of ray engines: seeded, small, and as awkward as the test wants them.
#pragma once
#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "core/geometry.h"
#include "core/ray.h"
#include "tests/support/random.h"

namespace twinray::test {

inline void add_triangle(Mesh& mesh, const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto first = std::uint32_t(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), {a, b, c});
  mesh.triangles.push_back({first, first + 1, first + 2});
}

/// Triangles of about `size` in the cube [-1, 1]^3.
inline Mesh soup(int count, float size, std::uint64_t seed) {
  Random random(seed);
  Mesh mesh{.name = "soup"};
  for (int i = 0; i < count; ++i) {
    const Vec3 center = random.in_cube();
    const Vec3 a = random.in_cube(size), b = random.in_cube(size), c = random.in_cube(size);
    add_triangle(mesh, center + a, center + b, center + c);
  }
  return mesh;
}

inline SphereSet random_spheres(int count, float radius, std::uint64_t seed) {
  Random random(seed);
  SphereSet set{.name = "spheres"};
  for (int i = 0; i < count; ++i) {
    const Vec3 center = random.in_cube();
    set.spheres.push_back({center, radius * (0.1f + random.unit())});
  }
  return set;
}

/// A closed, regular mesh of 20 * 4^levels triangles on the unit sphere; neighbours share their vertices.
inline Mesh icosphere(int levels) {
  const float g = 1.618034f;
  Mesh mesh{.name = "icosphere"};
  for (const Vec3 p : {Vec3{-1, g, 0},
                       {1, g, 0},
                       {-1, -g, 0},
                       {1, -g, 0},
                       {0, -1, g},
                       {0, 1, g},
                       {0, -1, -g},
                       {0, 1, -g},
                       {g, 0, -1},
                       {g, 0, 1},
                       {-g, 0, -1},
                       {-g, 0, 1}})
    mesh.positions.push_back(normalize(p));
  mesh.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [entry, is_new] =
          middles.try_emplace(std::minmax(a, b), std::uint32_t(mesh.positions.size()));
      if (is_new) mesh.positions.push_back(normalize(mesh.positions[a] + mesh.positions[b]));
      return entry->second;
    };
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : mesh.triangles) {
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(finer);
  }
  return mesh;
}

inline std::shared_ptr<const Geometry> share(std::vector<Shape> shapes) {
  return std::make_shared<const Geometry>(std::move(shapes));
}

/// Rays from anywhere around a box through anywhere in it.
inline std::vector<Ray> random_rays(int count, const Aabb& box, std::uint64_t seed) {
  Random random(seed);
  std::vector<Ray> rays;
  const Vec3 center = box.center(), extent = box.extent();
  const float size = std::max(extent.x, std::max(extent.y, extent.z));
  for (int i = 0; i < count; ++i) {
    const Vec3 origin = center + random.in_cube(size);
    const Vec3 target = center + random.in_cube(size * 0.5f);
    rays.push_back({.origin = origin, .direction = target - origin});
  }
  return rays;
}

}  // namespace twinray::test
