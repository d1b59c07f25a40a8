// SPDX-License-Identifier: Apache-2.0
// A ray that goes straight on through surfaces, and what it is in behind each. It stays the same ray and only
// begins later: moved off a surface, it would miss whatever lies just behind.
#pragma once
#include <optional>

#include "core/interiors.h"
#include "core/ray.h"
#include "core/scene.h"
#include "core/surface.h"

namespace twinray {

class StraightOn {
 public:
  /// `first`: what the ray is in where it begins. The scene must outlive it.
  StraightOn(const Scene& scene, const Interiors& first) : scene_(scene), interiors_(first) {}

  /// Goes through the surface of a hit of the ray, which from now on begins behind it. Of several
  /// surfaces with the same t the first one hides the others, in the order of the scene
  /// (accel/accelerator.h).
  void pass(const Hit& hit, Ray& ray);
  /// Where the ray begins now.
  const Interiors& interiors() const { return interiors_; }

  /// A surface that it went through.
  struct Crossing {
    SurfacePoint point;
    float t;
  };
  /// Whether two of them, one after the other, are one crossing of a shape on an edge of two of its
  /// triangles: both are on the same side of it, and no farther apart than what rounding explains.
  static bool are_one(const Crossing& a, const Crossing& b, const Vec3& direction);

 private:
  const Scene& scene_;
  Interiors interiors_;
  std::optional<Crossing> before_;
};

}  // namespace twinray
