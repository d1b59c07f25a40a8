// SPDX-License-Identifier: Apache-2.0
// The shapes that rays meet: triangle meshes and sets of spheres, plain data that is checked once and then
// constant.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "core/aabb.h"
#include "core/acceptance.h"
#include "core/coordinate_set.h"
#include "core/coordinates.h"
#include "core/facet.h"
#include "core/hit.h"
#include "core/instance.h"
#include "core/vec.h"

namespace twinray {

/// Three indices into an array of vertices (or normals, or texture coordinates), in winding order.
using Triangle = std::array<std::uint32_t, 3>;

/// A triangle mesh. The front of a triangle is where its vertices appear counter-clockwise.
struct Mesh {
  std::string name;
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
  std::vector<Vec3> normals;             ///< Unit shading normals, or empty: the mesh shades flat.
  std::vector<Triangle> normal_indices;  ///< One for each triangle where there are normals.
  std::vector<Vec2> uvs;                 ///< Texture coordinates, or empty.
  std::vector<Triangle> uv_indices;      ///< One for each triangle where there are uvs.
  std::vector<Vec2> second_uvs;          ///< Further ones, by which colours and numbers may go, or empty.
  std::vector<Triangle> second_uv_indices;
  bool is_opaque = true;  ///< Every hit counts; else Geometry::accepts() is asked.
};

/// A set of a mesh's texture coordinates: both are empty where it has none.
struct UvSet {
  const std::vector<Vec2>& uvs;
  const std::vector<Triangle>& indices;
};
/// The second of a mesh of one set is its first.
inline UvSet uv_set(const Mesh& mesh, CoordinateSet set) {
  if (set == CoordinateSet::second && !mesh.second_uvs.empty())
    return {mesh.second_uvs, mesh.second_uv_indices};
  return {mesh.uvs, mesh.uv_indices};
}

struct Sphere {
  Vec3 center;
  float radius = 1;  ///< > 0; a sphere without radius is never hit.
};

struct SphereSet {
  std::string name;
  std::vector<Sphere> spheres;
  bool is_opaque = true;  ///< As a mesh's.
};

using Shape = std::variant<Mesh, SphereSet>;

/// Takes the triangles out that have no area or a corner that is not finite; returns how many.
std::size_t drop_degenerate_triangles(Mesh& mesh);

/// All shapes of a scene. A Hit's `mesh` is an index into shapes(), its `primitive` one into that shape, its
/// `instance` one into instances(), of which it is the shape of the prototype.
class Geometry {
 public:
  Geometry() = default;
  /// Throws Error, naming the shape and the element, for an index out of range, a coordinate that is not
  /// finite or beyond max_coordinate, normals or uvs whose indices do not match the triangles, a negative
  /// radius, a shape that is not opaque where nothing says which hits count, prototypes that do not follow
  /// each other, and what PlacedInstances refuses.
  explicit Geometry(std::vector<Shape> shapes, std::shared_ptr<const Acceptance> acceptance = nullptr,
                    Instancing instancing = {});

  const std::vector<Shape>& shapes() const { return shapes_; }
  const Mesh* mesh(std::uint32_t shape) const { return std::get_if<Mesh>(&shapes_[shape]); }
  const SphereSet* sphere_set(std::uint32_t shape) const { return std::get_if<SphereSet>(&shapes_[shape]); }
  bool is_opaque(std::uint32_t shape) const {
    return std::visit([](const auto& s) { return s.is_opaque; }, shapes_[shape]);
  }
  /// Whether a hit of a shape that is not opaque counts (core/acceptance.h).
  bool accepts(const Vec3& origin, const Vec3& direction, const Hit& hit) const noexcept {
    return acceptance_->accepts(*this, origin, direction, hit);
  }
  /// Null where all shapes are opaque, mostly.
  const std::shared_ptr<const Acceptance>& acceptance() const { return acceptance_; }
  /// Of a triangle of a mesh.
  Facet facet(std::uint32_t shape, std::uint32_t triangle) const {
    const Mesh& in = *mesh(shape);
    const auto& [a, b, c] = in.triangles[triangle];
    return {in.positions[a], in.positions[b], in.positions[c]};
  }
  /// Those that stand in the scene directly: the first ones.
  ShapeRange direct_shapes() const { return direct_; }
  /// Those that instances place, by prototype.
  const std::vector<ShapeRange>& prototypes() const { return prototypes_; }
  const PlacedInstances& placed() const { return placed_; }
  const std::vector<Instance>& instances() const { return placed_.instances(); }
  bool has_instances() const { return !instances().empty(); }
  /// The transform of a hit's shape into the scene; null where it stands there directly.
  const Transform* to_world(std::uint32_t instance) const {
    return instance == no_instance ? nullptr : &instances()[instance].to_world;
  }
  /// The box of everything that stands in the scene; empty where nothing does.
  const Aabb& bounds() const { return bounds_; }
  /// The box of a shape, in its own space.
  const Aabb& bounds(std::uint32_t shape) const { return shape_bounds_[shape]; }
  std::size_t triangle_count() const { return triangle_count_; }
  std::size_t sphere_count() const { return sphere_count_; }
  /// All that are stored, those of prototypes once.
  std::size_t primitive_count() const { return triangle_count_ + sphere_count_; }
  /// Those that rays can meet: those of a prototype as often as it stands in the scene.
  std::uint64_t seen_primitives() const;
  /// Those of some shapes.
  std::size_t primitive_count(ShapeRange shapes) const;

 private:
  /// Boxes that hold all primitives of some shapes with this box: those of a grid's cells.
  std::vector<Aabb> parts_of(ShapeRange shapes, const Aabb& box) const;

  std::vector<Shape> shapes_;
  std::shared_ptr<const Acceptance> acceptance_;
  ShapeRange direct_;
  std::vector<ShapeRange> prototypes_;
  PlacedInstances placed_;
  std::vector<Aabb> shape_bounds_;
  Aabb bounds_;
  std::size_t triangle_count_ = 0, sphere_count_ = 0;
};

/// Whether a triangle has any area, as far as double arithmetic can tell. Not inline: a copy in a user's
/// program, compiled with flags of his own, could take the place of ours.
bool has_area(const Vec3& a, const Vec3& b, const Vec3& c);

/// The box of one primitive, rounded outward where it is not exact.
inline Aabb triangle_bounds(const Vec3& a, const Vec3& b, const Vec3& c) {
  Aabb box{a, a};
  box.extend(b);
  box.extend(c);
  return box;
}
Aabb sphere_bounds(const Sphere& sphere);

}  // namespace twinray
