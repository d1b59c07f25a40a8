// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <span>

#include "core/hit.h"
#include "core/interiors.h"
#include "core/ray.h"
#include "core/rgb.h"
#include "integrators/flight.h"

namespace twinray {

/// How far light has been followed along a ray: up to t_min, behind which its hit is the first one.
struct Way {
  Ray ray;
  Hit hit;
  Interiors interiors;  ///< At t_min.
  Rgb left{1, 1, 1};    ///< What media have left of the light up to t_min, but for those of the flight.
  std::optional<Flight> flight;  ///< Of a path that media scatter, rather than dim alone.
  bool is_scattered = false;     ///< One has, before the hit.

  /// How far it is to the ray's parameter t.
  float length_to(float t) const { return (t - ray.t_min) * length(ray.direction); }
  /// Goes on within the interiors up to the parameter t. False where the path is scattered before it.
  bool goes_on(std::span<const Material> materials, float t) {
    const Material* const medium = flight ? scattering_medium(materials, interiors) : nullptr;
    if (medium)
      is_scattered = flight->ends_within(medium->interior, length_to(t));
    else
      left = left * transmittance(materials, interiors, length_to(t));
    return !is_scattered;
  }
  /// What there is of a path's throughput where it has come to.
  Rgb weight() const { return flight ? left * flight->weight() : left; }
  /// The ray's parameter where the path is scattered,
  float t_scattered() const { return ray.t_min + flight->distance() / length(ray.direction); }
  /// and that point.
  Vec3 scattered_at() const { return ray.origin + ray.direction * t_scattered(); }
};

}  // namespace twinray
