// SPDX-License-Identifier: Apache-2.0
#include "core/geometry.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/area_vector.h"
#include "core/error.h"
#include "core/offset.h"

namespace twinray {
namespace {

std::string shape_label(const std::string& name, std::size_t index) {
  return name.empty() ? fmt::format("shape {}", index) : fmt::format("shape {} \"{}\"", index, name);
}

void check_coordinate(const Vec3& p, const std::string& label, const char* element, std::size_t i) {
  if (max_abs(p) <= max_coordinate && is_finite(p)) return;
  throw Error(fmt::format("{}: {} {} is ({}, {}, {}); coordinates must be finite and within +-{:g}", label,
                          element, i, p.x, p.y, p.z, max_coordinate));
}

void check_indices(const std::vector<Triangle>& triangles, std::size_t count, const std::string& label,
                   const char* what) {
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (const std::uint32_t index : triangles[i])
      if (index >= count)
        throw Error(fmt::format("{}: triangle {} names {} {}; there are {}", label, i, what, index, count));
}

void check_attribute(const std::vector<Triangle>& indices, std::size_t count, const Mesh& mesh,
                     const std::string& label, const char* what) {
  if (count == 0 && indices.empty()) return;
  if (indices.size() != mesh.triangles.size())
    throw Error(fmt::format("{}: {} triangles but {} triples of {} indices", label, mesh.triangles.size(),
                            indices.size(), what));
  check_indices(indices, count, label, what);
}

Aabb check(const Mesh& mesh, const std::string& label) {
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    check_coordinate(mesh.positions[i], label, "vertex", i);
  check_indices(mesh.triangles, mesh.positions.size(), label, "vertex");
  check_attribute(mesh.normal_indices, mesh.normals.size(), mesh, label, "normal");
  check_attribute(mesh.uv_indices, mesh.uvs.size(), mesh, label, "uv");
  Aabb bounds;
  for (const Triangle& triangle : mesh.triangles)
    for (const std::uint32_t index : triangle) bounds.extend(mesh.positions[index]);
  return bounds;
}

Aabb check(const SphereSet& set, const std::string& label) {
  Aabb bounds;
  for (std::size_t i = 0; i < set.spheres.size(); ++i) {
    const Sphere& sphere = set.spheres[i];
    check_coordinate(sphere.center, label, "the centre of sphere", i);
    if (!(sphere.radius >= 0 && sphere.radius <= max_coordinate))
      throw Error(fmt::format("{}: the radius of sphere {} is {}; it must lie in [0, {:g}]", label, i,
                              sphere.radius, max_coordinate));
    bounds.extend(sphere_bounds(sphere));
  }
  return bounds;
}

/// One for each triangle of a mesh whose indices are valid.
std::vector<Facet> facets_of(const Mesh& mesh) {
  std::vector<Facet> facets;
  facets.reserve(mesh.triangles.size());
  for (const auto& [ia, ib, ic] : mesh.triangles) {
    const Vec3 &a = mesh.positions[ia], &b = mesh.positions[ib], &c = mesh.positions[ic];
    facets.push_back({AreaVector(a, b, c).normal(), triangle_offset(a, b, c)});
  }
  return facets;
}

}  // namespace

std::size_t drop_degenerate_triangles(Mesh& mesh) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto [a, b, c] = mesh.triangles[i];
    const Vec3 &p = mesh.positions[a], &q = mesh.positions[b], &r = mesh.positions[c];
    if (!is_finite(p) || !is_finite(q) || !is_finite(r) || !has_area(p, q, r)) continue;
    mesh.triangles[kept] = mesh.triangles[i];
    if (!mesh.normal_indices.empty()) mesh.normal_indices[kept] = mesh.normal_indices[i];
    if (!mesh.uv_indices.empty()) mesh.uv_indices[kept] = mesh.uv_indices[i];
    ++kept;
  }
  const std::size_t dropped = mesh.triangles.size() - kept;
  mesh.triangles.resize(kept);
  if (!mesh.normal_indices.empty()) mesh.normal_indices.resize(kept);
  if (!mesh.uv_indices.empty()) mesh.uv_indices.resize(kept);
  return dropped;
}

Geometry::Geometry(std::vector<Shape> shapes, std::shared_ptr<const Acceptance> acceptance)
    : shapes_(std::move(shapes)), acceptance_(std::move(acceptance)), facets_(shapes_.size()) {
  for (std::size_t i = 0; i < shapes_.size(); ++i) {
    std::visit(
        [&](const auto& shape) {
          const std::string label = shape_label(shape.name, i);
          bounds_.extend(check(shape, label));
          if (!shape.is_opaque && !acceptance_)
            throw Error(fmt::format("{}: it is not opaque, but nothing says which of its hits count", label));
        },
        shapes_[i]);
    if (const Mesh* m = mesh(std::uint32_t(i))) {
      triangle_count_ += m->triangles.size();
      facets_[i] = facets_of(*m);
    }
    if (const SphereSet* set = sphere_set(std::uint32_t(i))) sphere_count_ += set->spheres.size();
  }
}

namespace {

/// std::nextafter(x, infinity), which the C library makes a call of: each test of a sphere asks for six.
float next_up(float x) {
  if (!std::isfinite(x)) return x == -Aabb::infinity ? std::numeric_limits<float>::lowest() : x;
  if (x == 0) return std::numeric_limits<float>::denorm_min();
  const auto bits = std::bit_cast<std::uint32_t>(x);
  return std::bit_cast<float>(x > 0 ? bits + 1 : bits - 1);
}
float next_down(float x) { return -next_up(-x); }

}  // namespace

Aabb sphere_bounds(const Sphere& sphere) {
  Aabb box;
  for (int axis = 0; axis < 3; ++axis) {
    box.lower[axis] = next_down(sphere.center[axis] - sphere.radius);
    box.upper[axis] = next_up(sphere.center[axis] + sphere.radius);
  }
  return box;
}

bool has_area(const Vec3& a, const Vec3& b, const Vec3& c) { return !AreaVector(a, b, c).is_zero(); }

}  // namespace twinray
