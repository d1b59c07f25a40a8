// SPDX-License-Identifier: Apache-2.0
// Surfaces that are not there: light goes straight through an Interface, from one interior into another. Rays
// pass them on their way; they are no vertices of paths, and hide no light.
#pragma once
#include <vector>

#include "core/interiors.h"
#include "core/scene.h"
#include "integrators/straight_on.h"
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
  const Scene& scene() const { return scene_; }

  /// Follows a ray of a path through all passages, to the first surface that is there, or to none; to the
  /// passage before which it is scattered, if any.
  void follow(Tracer& tracer, Way& way) const;
  /// What comes along a shadow ray that starts in these interiors.
  Rgb visibility(Tracer& tracer, const Ray& shadow_ray, const Interiors& interiors) const;

 private:
  const Scene& scene_;
  std::vector<bool> is_passage_;  ///< By shape; empty where none is.
};

/// A ray on its way through passages, from one hit to the next.
class PassingRay {
 public:
  /// Whoever passes more is lost between surfaces that lie in each other.
  static constexpr int most_passages = 10000;

  /// The passages must outlive it.
  PassingRay(const Passages& passages, const Way& way)
      : passages_(&passages), way_(way), through_(passages.scene(), way.interiors) {}

  /// What must be traced of it.
  Ray ray() const { return way_.needed_ray(passages_->scene()); }
  /// Goes on by what that hits: through a passage. False where it hits none, or is scattered before it.
  bool goes_on(const Hit& hit);
  /// How far it has come: once it goes on no more, to the last hit.
  const Way& way() const { return way_; }

 private:
  const Passages* passages_;
  Way way_;
  StraightOn through_;
  int passed_ = 0;
};

}  // namespace twinray
