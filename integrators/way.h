// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <optional>

#include "core/hit.h"
#include "core/interiors.h"
#include "core/ray.h"
#include "core/rgb.h"
#include "core/scene.h"
#include "integrators/flight.h"
#include "integrators/medium_column.h"
#include "integrators/medium_glow.h"

namespace twinray {

/// The part of light that interiors leave along a ray, from where it begins up to its parameter t, which may
/// be infinite: what is neither absorbed nor scattered.
inline Rgb transmittance(const Scene& scene, const Interiors& interiors, const Ray& ray, float t) {
  const Interior* const medium = medium_in(scene.materials, interiors);
  if (!medium) return {1, 1, 1};
  const Rgb extinction = medium->extinction();
  return transmittance(extinction, MediumColumn(scene, *medium, ray, t).amount(opaque_amount(extinction)));
}

/// How far light has been followed along a ray: up to t_min, behind which its hit is the first one, or there
/// is none in the part that is needed.
struct Way {
  Ray ray;
  Hit hit;
  Interiors interiors;  ///< At t_min.
  Rgb left{1, 1, 1};    ///< What media have left of the light up to t_min, but for those of the flight.
  std::optional<Flight> flight;  ///< Of a path that media scatter, rather than dim alone.
  /// Of a path that looks for light of media: which points of theirs it sees,
  std::optional<float> glow_draw = {};
  Rgb glow;                   ///< and what it has found up to t_min, as it comes to where the way begins.
  bool is_scattered = false;  ///< One has, before the hit.

  /// The part of the ray in which a hit matters: no longer than the path goes on before it is scattered in an
  /// even medium, so that less of the scene is searched; but all of a medium that glows is seen.
  Ray needed_ray(const Scene& scene) const {
    Ray needed = ray;
    const Interior* const medium = medium_in(scene.materials, interiors);
    if (flight && medium && scatters(*medium) && medium->density == no_density && !glows(*medium))
      needed.t_max = std::min(ray.t_max, t_beyond(ray, flight->reach(*medium)));
    return needed;
  }
  /// Goes on within the interiors up to the parameter t. False where the path is scattered before it.
  bool goes_on(const Scene& scene, float t) {
    const Interior* const medium = medium_in(scene.materials, interiors);
    if (medium && glows(*medium)) glow += weight() * medium_glow(scene, *medium, ray, t, *glow_draw);
    if (flight && medium && scatters(*medium))
      is_scattered = flight->ends_within(*medium, MediumColumn(scene, *medium, ray, t));
    else
      left = left * transmittance(scene, interiors, ray, t);
    return !is_scattered;
  }
  /// Goes on to where it ends: at its hit, or where a medium scatters the path.
  void ends(const Scene& scene) {
    if (!is_scattered) goes_on(scene, hit.t);
  }
  /// What there is of a path's throughput where it has come to.
  Rgb weight() const { return flight ? left * flight->weight() : left; }
  /// The ray's parameter where the path is scattered,
  float t_scattered() const { return ray.t_min + flight->distance() / length(ray.direction); }
  /// and that point.
  Vec3 scattered_at() const { return ray.origin + ray.direction * t_scattered(); }

 private:
  bool glows(const Interior& medium) const { return glow_draw && medium.emits(); }
};

/// What comes along a shadow ray that has been followed to its last hit: nothing, if that is one.
inline Rgb visibility(const Scene& scene, Way way) {
  if (!way.hit.is_miss()) return {};
  way.goes_on(scene, way.ray.t_max);
  return way.left;
}

}  // namespace twinray
