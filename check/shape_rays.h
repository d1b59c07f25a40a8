// SPDX-License-Identifier: Apache-2.0
// Rays made from the shapes of a geometry, where engines are most likely to differ.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "accel/accelerator.h"
#include "check/ray_class.h"
#include "core/random.h"

namespace twinray {

/// Makes the rays of all classes but camera, shadow and bounce. A ray is a pure function of the geometry, the
/// seed, its class and its number. Safe from any thread.
class ShapeRays {
 public:
  /// `engine` is asked where hits are, for the class `ends`; it must outlive this.
  ShapeRays(std::shared_ptr<const Geometry> geometry, const Accelerator& engine, std::uint64_t seed);

  /// For the classes moved, shrunk and grown the geometry is the placed one. Throws Error for camera, shadow
  /// and bounce.
  Ray ray(RayClass ray_class, std::uint64_t number) const;

 private:
  using Corners = std::array<Vec3, 3>;
  /// The corners of a primitive of the geometry by its number, in its own space.
  Corners own_corners(std::uint64_t number) const;
  Ray make(RayClass ray_class, Random& random) const;
  /// The corners of a triangle chosen by chance; of a sphere, three points on it.
  Corners corners(Random& random) const;
  /// A point of the scene's box, enlarged by `reach`.
  Vec3 point(Random& random, float reach) const;

  Ray random_ray(Random& random) const;
  Ray vertex_ray(Random& random) const;
  Ray edge_ray(Random& random) const;
  Ray axis_ray(Random& random) const;
  Ray box_face_ray(Random& random) const;
  Ray grazing_ray(Random& random) const;
  Ray surface_ray(Random& random) const;
  Ray end_ray(Random& random) const;
  Ray direction_ray(Random& random) const;
  Ray far_ray(Random& random) const;
  Ray mixed_ray(Random& random) const;

  std::shared_ptr<const Geometry> geometry_;
  const Accelerator& engine_;
  std::uint64_t seed_;
  std::vector<std::uint64_t> ends_;  ///< Of each shape: the number of primitives up to its last.
  /// Of what stands in the scene directly, and of each instance: the number of primitives up to its last.
  std::vector<std::uint64_t> standing_;
  Vec3 center_;
  float size_ = 1;  ///< Half of the longest side of the scene's box.
};

}  // namespace twinray
