// SPDX-License-Identifier: Apache-2.0
#include "core/geometry.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>

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
  check_attribute(mesh.second_uv_indices, mesh.second_uvs.size(), mesh, label, "second uv");
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

}  // namespace

std::size_t drop_degenerate_triangles(Mesh& mesh) {
  const std::array lists{&mesh.triangles, &mesh.normal_indices, &mesh.uv_indices, &mesh.second_uv_indices};
  std::size_t kept = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto [a, b, c] = mesh.triangles[i];
    const Vec3 &p = mesh.positions[a], &q = mesh.positions[b], &r = mesh.positions[c];
    if (!is_finite(p) || !is_finite(q) || !is_finite(r) || !has_area(p, q, r)) continue;
    for (std::vector<Triangle>* const list : lists)
      if (!list->empty()) (*list)[kept] = (*list)[i];
    ++kept;
  }
  const std::size_t dropped = mesh.triangles.size() - kept;
  for (std::vector<Triangle>* const list : lists)
    if (!list->empty()) list->resize(kept);
  return dropped;
}

namespace {

/// The shapes before the first prototype.
ShapeRange direct_of(const std::vector<ShapeRange>& prototypes, std::size_t shapes) {
  if (prototypes.empty()) return {0, std::uint32_t(shapes)};
  std::uint64_t next = prototypes.front().first;
  for (std::size_t i = 0; i < prototypes.size(); ++i) {
    const auto& [first, count] = prototypes[i];
    if (first != next)
      throw Error(fmt::format("prototype {} begins with shape {}; it must begin with {}", i, first, next));
    next += count;
  }
  if (next != shapes)
    throw Error(fmt::format("the prototypes end before shape {}; there are {} shapes", next, shapes));
  return {0, prototypes.front().first};
}

}  // namespace

Geometry::Geometry(std::vector<Shape> shapes, std::shared_ptr<const Acceptance> acceptance,
                   Instancing instancing)
    : shapes_(std::move(shapes)),
      acceptance_(std::move(acceptance)),
      direct_(direct_of(instancing.prototypes, shapes_.size())),
      prototypes_(std::move(instancing.prototypes)),
      shape_bounds_(shapes_.size()) {
  for (std::size_t i = 0; i < shapes_.size(); ++i) {
    std::visit(
        [&](const auto& shape) {
          const std::string label = shape_label(shape.name, i);
          shape_bounds_[i] = check(shape, label);
          if (!shape.is_opaque && !acceptance_)
            throw Error(fmt::format("{}: it is not opaque, but nothing says which of its hits count", label));
        },
        shapes_[i]);
    if (const Mesh* m = mesh(std::uint32_t(i))) triangle_count_ += m->triangles.size();
    if (const SphereSet* set = sphere_set(std::uint32_t(i))) sphere_count_ += set->spheres.size();
  }
  const auto bounds_of = [&](ShapeRange range) {
    Aabb bounds;
    for (std::uint32_t i = range.first; i < range.end(); ++i) bounds.extend(shape_bounds_[i]);
    return bounds;
  };
  bounds_ = bounds_of(direct_);
  std::vector<std::vector<Aabb>> parts;
  for (const ShapeRange& prototype : prototypes_) parts.push_back(parts_of(prototype, bounds_of(prototype)));
  placed_ = PlacedInstances(std::move(instancing.instances), parts, bounds_);
  bounds_.extend(placed_.bounds());
}

std::vector<Aabb> Geometry::parts_of(ShapeRange shapes, const Aabb& box) const {
  constexpr int side = 4;
  if (box.is_empty()) return {};
  const Vec3 extent = box.extent();
  std::vector<Aabb> cells(side * side * side);
  const auto add = [&](const Aabb& primitive) {
    std::size_t cell = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const float where = (primitive.center()[axis] - box.lower[axis]) / extent[axis];
      cell = side * cell + std::size_t(where > 0 ? std::min(side - 1, int(where * side)) : 0);
    }
    cells[cell].extend(primitive);
  };
  for (std::uint32_t i = shapes.first; i < shapes.end(); ++i) {
    if (const Mesh* m = mesh(i))
      for (const auto& [a, b, c] : m->triangles)
        add(triangle_bounds(m->positions[a], m->positions[b], m->positions[c]));
    else
      for (const Sphere& sphere : sphere_set(i)->spheres) add(sphere_bounds(sphere));
  }
  std::erase_if(cells, [](const Aabb& cell) { return cell.is_empty(); });
  return cells;
}

std::uint64_t Geometry::seen_primitives() const {
  std::vector<std::uint64_t> of_prototypes;
  for (const ShapeRange& prototype : prototypes_) of_prototypes.push_back(primitive_count(prototype));
  std::uint64_t seen = primitive_count(direct_);
  for (const Instance& instance : instances()) seen += of_prototypes[instance.prototype];
  return seen;
}

std::size_t Geometry::primitive_count(ShapeRange shapes) const {
  std::size_t count = 0;
  for (std::uint32_t i = shapes.first; i < shapes.end(); ++i)
    count += mesh(i) ? mesh(i)->triangles.size() : sphere_set(i)->spheres.size();
  return count;
}

}  // namespace twinray
