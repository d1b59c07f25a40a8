// SPDX-License-Identifier: Apache-2.0
// Instances: shapes that are stored once, and stand in the scene wherever a transform places them.
//
// A ray meets an instance in the instance's own space: its origin and direction are transformed there, and t
// keeps its meaning, for the direction is not made a unit vector. What is hit is decided there, by the same
// tests. One thing is asked in the scene's space: the box of the instance, to which the ray's interval is
// clipped, so that a tree over such boxes loses no hit (docs/agreement.md has the proof).
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "core/aabb.h"
#include "core/transform.h"

namespace twinray {

/// Shapes [first, first + count) of a geometry.
struct ShapeRange {
  std::uint32_t first = 0, count = 0;

  std::uint32_t end() const { return first + count; }
  friend bool operator==(const ShapeRange&, const ShapeRange&) = default;
};

/// A prototype that stands in the scene, moved there by an affine transform.
struct Instance {
  std::uint32_t prototype = 0;  ///< Index into Geometry::prototypes().
  Transform to_world;
};

/// Which shapes of a geometry stand in the scene by instances alone, and where. Without prototypes none do.
struct Instancing {
  /// Each behind the one before, the last one up to the last shape; the shapes before the first one stand in
  /// the scene directly.
  std::vector<ShapeRange> prototypes;
  std::vector<Instance> instances;
};

/// A transform may stretch and shrink lengths by no more, seen by the largest component,
inline constexpr double max_instance_scale = 0x1p36;
/// and stretch one direction by no more than this times what it does to another.
inline constexpr double max_instance_squash = 0x1p20;

/// Whether an instance may have this transform.
bool can_place(const Transform& to_world);

/// What a ray needs of an instance: two cache lines, side by side. At a place that is no multiple of it, it
/// would reach into a third one, for which a batch of rays waits.
struct alignas(128) PlacedInstance {
  Transform to_object;  ///< From the scene's space into the prototype's.
  /// Of the scene's space, widened: every hit of the instance lies within the interval of a ray, from no
  /// farther than PlacedInstances::reach(), in this box. Empty where the prototype is.
  Aabb box;
  std::uint32_t prototype = 0;
};
static_assert(sizeof(PlacedInstance) == alignof(PlacedInstance));

/// Instances, ready for rays.
class PlacedInstances {
 public:
  PlacedInstances() = default;
  /// `parts`: of each prototype boxes that hold its primitives, the more the closer; `direct`: the box of
  /// what stands in the scene directly. Throws Error that names the instance: for a prototype that there is
  /// not, a transform that is not finite, stretches beyond the bounds above or flattens, and for one that
  /// reaches beyond max_coordinate.
  PlacedInstances(std::vector<Instance> instances, const std::vector<std::vector<Aabb>>& parts,
                  const Aabb& direct);

  const std::vector<Instance>& instances() const { return instances_; }
  const PlacedInstance& operator[](std::uint32_t instance) const { return placed_[instance]; }
  /// The box of all of them, not widened; empty where nothing can be hit.
  const Aabb& bounds() const { return bounds_; }
  /// The largest coordinate of the whole scene. Rays from farther away see all boxes widened by
  /// far_margin() times their origin's largest component.
  float reach() const { return reach_; }
  float far_margin() const { return far_margin_; }

 private:
  std::vector<Instance> instances_;
  std::vector<PlacedInstance> placed_;
  Aabb bounds_;
  float reach_ = 0, far_margin_ = 0;
};

}  // namespace twinray
