// SPDX-License-Identifier: Apache-2.0
// Surfaces that are not there: light goes straight through an Interface, from one interior into another, and
// through the surface of a Hair that it comes to from within. Rays pass them on their way; they are no
// vertices of paths, and hide no light.
#pragma once
#include <cstdint>
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
  bool empty() const { return kinds_.empty(); }
  /// Whether a ray has hit one.
  bool is_one(const Ray& ray, const Hit& hit) const {
    if (empty() || hit.is_miss()) return false;
    const Kind kind = kinds_[hit.mesh];
    return kind == Kind::interface || (kind == Kind::fibre && is_from_within(ray, hit));
  }
  const Scene& scene() const { return scene_; }

  /// Follows a ray of a path through all passages, to the first surface that is there, or to none; to the
  /// passage before which it is scattered, if any.
  void follow(Tracer& tracer, Way& way) const;
  /// What comes along a shadow ray that starts in these interiors.
  Rgb visibility(Tracer& tracer, const Ray& shadow_ray, const Interiors& interiors) const;

 private:
  enum class Kind : std::uint8_t {
    none,
    interface,  ///< On both sides,
    fibre       ///< or to who comes from within.
  };
  static Kind kind_of(const SurfaceModel& model);
  bool is_from_within(const Ray& ray, const Hit& hit) const;

  const Scene& scene_;
  std::vector<Kind> kinds_;  ///< Of the shapes; empty where all are none.
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
