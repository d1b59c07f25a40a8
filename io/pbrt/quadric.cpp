// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/quadric.h"

#include <algorithm>
#include <cmath>

#include "core/angle.h"
#include "core/elementary.h"

namespace twinray {
namespace {

constexpr std::uint32_t edges_around = 256;

/// A grid of columns x rows cells over the unit square: point(u, v) gives position and normal.
template <typename Point>
Mesh grid(std::uint32_t columns, std::uint32_t rows, const Point& point) {
  Mesh mesh;
  for (std::uint32_t j = 0; j <= rows; ++j)
    for (std::uint32_t i = 0; i <= columns; ++i) {
      const Vec2 uv{float(i) / float(columns), float(j) / float(rows)};
      const auto [position, normal] = point(double(uv.x), double(uv.y));
      mesh.positions.push_back(position);
      mesh.normals.push_back(normal);
      mesh.uvs.push_back(uv);
    }
  for (std::uint32_t j = 0; j < rows; ++j)
    for (std::uint32_t i = 0; i < columns; ++i) {
      const std::uint32_t a = j * (columns + 1) + i, b = a + 1, c = a + columns + 1, d = c + 1;
      mesh.triangles.push_back({a, b, d});
      mesh.triangles.push_back({a, d, c});
    }
  mesh.normal_indices = mesh.uv_indices = mesh.triangles;
  drop_degenerate_triangles(mesh);  // at poles and centres
  return mesh;
}

struct Corner {
  Vec3 position, normal;
};

struct Angle {
  double cos, sin;

  Angle(double u, double phi_max_degrees) {
    const double phi = u * std::clamp(phi_max_degrees, 0.0, 360.0) * radians_per_degree;
    cos = cos_radians(phi), sin = sin_radians(phi);
  }
};

Vec3 vec(double x, double y, double z) { return {float(x), float(y), float(z)}; }

/// The angle from the +z axis at which a sphere has this height, in radians.
double theta_of(double z, double radius) {
  const double cosine = std::clamp(z / radius, -1.0, 1.0);
  return atan2_turns(std::sqrt(1 - cosine * cosine), cosine) * 360 * radians_per_degree;
}

using Corners = std::array<std::uint32_t, 4>;

float size_of(const Vec3& v) { return length(v); }
float size_of(const Vec2& v) { return std::sqrt(v.x * v.x + v.y * v.y); }

/// Whether values go evenly over a patch, as they do over its two triangles then. Differences below a part of
/// their size, or of the one that is given, are lost in facets.
template <typename Value>
bool is_even(const std::vector<Value>& values, const Corners& corners, float size = 0) {
  constexpr float part = 1e-4f;
  if (values.empty()) return true;
  const Value &a = values[corners[0]], &b = values[corners[1]], &c = values[corners[2]],
              &d = values[corners[3]];
  for (const Value& side : {d - a, b - a, c - a}) size = std::max(size, size_of(side));
  return size_of((d - c) - (b - a)) <= part * size;
}

template <typename Value>
Value bilinear(const std::vector<Value>& values, const Corners& corners, float u, float v) {
  return values[corners[0]] * ((1 - u) * (1 - v)) + values[corners[1]] * (u * (1 - v)) +
         values[corners[2]] * ((1 - u) * v) + values[corners[3]] * (u * v);
}

}  // namespace

Mesh sphere_mesh(const PartialSphere& sphere) {
  const double r = double(sphere.radius);
  const double bottom = theta_of(double(std::min(sphere.z_min, sphere.z_max)), r);
  const double top = theta_of(double(std::max(sphere.z_min, sphere.z_max)), r);
  return grid(edges_around, edges_around / 2, [&](double u, double v) {
    const Angle phi(u, double(sphere.phi_max_degrees));
    const double theta = bottom + v * (top - bottom);
    const double s = sin_radians(theta);
    const Vec3 normal = vec(s * phi.cos, s * phi.sin, cos_radians(theta));
    return Corner{vec(r * s * phi.cos, r * s * phi.sin, r * cos_radians(theta)), normal};
  });
}

/// In pbrt v runs from the outer edge to the inner one.
Mesh disk_mesh(const Disk& disk) {
  return grid(edges_around, 1, [&](double u, double v) {
    const Angle phi(u, double(disk.phi_max_degrees));
    const double r = double(disk.radius) + v * double(disk.inner_radius - disk.radius);
    return Corner{vec(r * phi.cos, r * phi.sin, double(disk.height)), {0, 0, 1}};
  });
}

Mesh cylinder_mesh(const Cylinder& cylinder) {
  const double r = double(cylinder.radius);
  return grid(edges_around, 1, [&](double u, double v) {
    const Angle phi(u, double(cylinder.phi_max_degrees));
    const double z = double(cylinder.z_min) + v * double(cylinder.z_max - cylinder.z_min);
    return Corner{vec(r * phi.cos, r * phi.sin, z), vec(phi.cos, phi.sin, 0)};
  });
}

void add_bilinear_patch(const std::array<std::uint32_t, 4>& corners, Mesh& mesh) {
  constexpr std::uint32_t cells = 16;
  const auto& p = mesh.positions;
  const auto add_cell = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    mesh.triangles.push_back({a, b, d});
    mesh.triangles.push_back({a, d, c});
  };
  if (is_even(p, corners) && is_even(mesh.normals, corners, 1) && is_even(mesh.uvs, corners))
    return add_cell(corners[0], corners[1], corners[2], corners[3]);
  const std::uint32_t first = std::uint32_t(p.size());
  for (std::uint32_t j = 0; j <= cells; ++j)
    for (std::uint32_t i = 0; i <= cells; ++i) {
      const float u = float(i) / cells, v = float(j) / cells;
      if (!mesh.normals.empty()) mesh.normals.push_back(bilinear(mesh.normals, corners, u, v));
      if (!mesh.uvs.empty()) mesh.uvs.push_back(bilinear(mesh.uvs, corners, u, v));
      mesh.positions.push_back(bilinear(mesh.positions, corners, u, v));
    }
  for (std::uint32_t j = 0; j < cells; ++j)
    for (std::uint32_t i = 0; i < cells; ++i) {
      const std::uint32_t a = first + j * (cells + 1) + i;
      add_cell(a, a + 1, a + cells + 1, a + cells + 2);
    }
}

}  // namespace twinray
