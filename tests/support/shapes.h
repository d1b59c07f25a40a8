// SPDX-License-Identifier: Apache-2.0
// Geometry and rays for tests of ray engines: seeded, small, and as awkward as the test wants them.
#pragma once
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "core/geometry.h"
#include "core/ray.h"
#include "tests/support/meshes.h"
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

/// Geometries that are hard to divide: none, one primitive, a thousand coincident, in one plane, on one line;
/// and two ordinary small ones.
inline std::vector<std::shared_ptr<const Geometry>> degenerate_geometries() {
  Mesh coincident, flat, line;
  for (int i = 0; i < 1000; ++i) {
    const float x = float(i);
    add_triangle(coincident, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    add_triangle(flat, {x, 0, 0}, {x + 1, 0, 0}, {x, 0, 1});
    add_triangle(line, {x, 0, 0}, {x + 1, 0, 0}, {x + 2, 0, 0});
  }
  return {share({}),
          share({Mesh{}, SphereSet{}}),
          share({soup(1, 1, 1)}),
          share({coincident}),
          share({flat}),
          share({line}),
          share({random_spheres(1, 1, 1)}),
          share({soup(2, 1, 1)}),
          share({random_spheres(500, 0.1f, 1)})};
}

}  // namespace twinray::test
