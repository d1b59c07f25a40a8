// SPDX-License-Identifier: Apache-2.0
#include "io/generated/mesh_parts.h"

#include "core/elementary.h"
#include "core/frame.h"

namespace twinray::generated {
namespace {

std::uint32_t add_position(Mesh& mesh, const Vec3& p) {
  mesh.positions.push_back(p);
  return std::uint32_t(mesh.positions.size() - 1);
}

/// The corners of the cube's face `face` are those of the square [-1, 1]^2 at +-1 of one axis.
Vec3 on_cube(int face, float u, float v) {
  const float s = 2 * u - 1, t = 2 * v - 1;
  switch (face) {
    case 0:
      return {1, s, t};
    case 1:
      return {-1, t, s};
    case 2:
      return {t, 1, s};
    case 3:
      return {s, -1, t};
    case 4:
      return {s, t, 1};
    default:
      return {t, s, -1};
  }
}

}  // namespace

void add_triangle(Mesh& mesh, const Vec3& a, const Vec3& b, const Vec3& c) {
  const std::uint32_t first = add_position(mesh, a);
  add_position(mesh, b);
  add_position(mesh, c);
  mesh.triangles.push_back({first, first + 1, first + 2});
}

void add_quad(Mesh& mesh, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const std::uint32_t first = add_position(mesh, a);
  for (const Vec3& p : {b, c, d}) add_position(mesh, p);
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.triangles.push_back({first, first + 2, first + 3});
}

void add_box(Mesh& mesh, const Aabb& box) { add_box(mesh, box, {}); }

void add_box(Mesh& mesh, const Aabb& box, const Transform& place) {
  const std::uint32_t first = std::uint32_t(mesh.positions.size());
  for (int i = 0; i < 8; ++i)
    add_position(mesh, place.point({i & 1 ? box.upper.x : box.lower.x, i & 2 ? box.upper.y : box.lower.y,
                                    i & 4 ? box.upper.z : box.lower.z}));
  constexpr Triangle sides[] = {{0, 3, 1}, {0, 2, 3}, {4, 7, 6}, {4, 5, 7}, {0, 5, 4}, {0, 1, 5},
                                {2, 7, 3}, {2, 6, 7}, {0, 6, 2}, {0, 4, 6}, {1, 7, 5}, {1, 3, 7}};
  for (const auto& [a, b, c] : sides) mesh.triangles.push_back({first + a, first + b, first + c});
}

void add_surface(Mesh& mesh, int columns, int rows, const SurfaceFunction& point) {
  const std::uint32_t first = std::uint32_t(mesh.positions.size());
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i)
      add_position(mesh, point(float(i) / float(columns), float(j) / float(rows)));
  const std::uint32_t stride = std::uint32_t(columns) + 1;
  for (std::uint32_t j = 0; j < std::uint32_t(rows); ++j)
    for (std::uint32_t i = 0; i < std::uint32_t(columns); ++i) {
      const std::uint32_t corner = first + j * stride + i;
      mesh.triangles.push_back({corner, corner + 1, corner + stride + 1});
      mesh.triangles.push_back({corner, corner + stride + 1, corner + stride});
    }
}

void add_tube(Mesh& mesh, const Tube& tube) {
  const Frame frame(normalize(tube.to - tube.from));
  add_surface(mesh, tube.sides, tube.rings, [&](float u, float v) {
    const SinCos turn = sincos_turns(u < 1 ? u : 0);  // The last column is the first one.
    const float radius = tube.radius_from + (tube.radius_to - tube.radius_from) * v;
    const Vec3 around = frame.tangent * turn.cos + frame.bitangent * turn.sin;
    return tube.from + (tube.to - tube.from) * v + around * radius;
  });
}

void add_ball(Mesh& mesh, const Vec3& center, int n, const RadiusFunction& radius) {
  for (int face = 0; face < 6; ++face)
    add_surface(mesh, n, n, [&](float u, float v) {
      const Vec3 direction = normalize(on_cube(face, u, v));
      return center + direction * radius(direction);
    });
}

void add_ball(Mesh& mesh, const Vec3& center, int n, float radius) {
  add_ball(mesh, center, n, [radius](const Vec3&) { return radius; });
}

}  // namespace twinray::generated
