// SPDX-License-Identifier: Apache-2.0
// Surfaces that are not there: light goes straight through an Interface, from one interior into another. Rays
// pass them on their way; they are no vertices of paths, and hide no light.
#pragma once
#include <vector>

#include "core/interiors.h"
#include "core/scene.h"
#include "integrators/tracer.h"
#include "integrators/way.h"

namespace twinray {

class Passages {
 public:
  /// The scene must outlive it.
  explicit Passages(const Scene& scene);

  /// Whether the scene has none.
  bool empty() const { return is_passage_.empty(); }
  bool is_one(const Hit& hit) const { return !empty() && !hit.is_miss() && is_passage_[hit.mesh]; }

  /// Follows a ray of a path through all passages, to the first surface that is there, or to none; to the
  /// passage before which it is scattered, if any.
  void follow(Tracer& tracer, Way& way) const;
  /// Follows a ray of a path to its end: to the first surface that is there, to none, or to where a medium
  /// scatters the path. What there is of the path's throughput there, relative to where the ray began.
  Rgb follow_to_end(Tracer& tracer, Way& way) const;
  /// What comes along a shadow ray that starts in these interiors.
  Rgb visibility(Tracer& tracer, const Ray& shadow_ray, const Interiors& interiors) const;

 private:
  void pass(Tracer& tracer, Way& way, RayKind kind) const;

  const Scene& scene_;
  std::vector<bool> is_passage_;  ///< By shape; empty where none is.
};

}  // namespace twinray
