// SPDX-License-Identifier: Apache-2.0
// Who watches PathReference trace a path: told each step, and what it brings. By default nothing is done with
// it.
#pragma once
#include <cstdint>
#include <optional>

#include "core/hit.h"
#include "core/light_sample.h"
#include "core/ray.h"
#include "core/rgb.h"
#include "core/scene.h"
#include "integrators/interaction.h"

namespace twinray {

struct LightTransport;
struct Scattering;

/// A ray of the path has come to its end.
struct PathArrival {
  Ray ray;
  Hit hit;         ///< A miss where it has left the scene, or has ended in a medium.
  Rgb throughput;  ///< Of the path, along the ray.
  /// What media on the way have left of the light; the throughput is after it.
  Rgb transmittance{1, 1, 1};
  /// Media scatter on the way: the above is over the probability that the path has come so far or, where it
  /// was scattered, what is scattered over the density of that (integrators/flight.h).
  bool is_flight = false;
  /// The ray comes from below a surface (integrators/walk_below.h), where the path was scattered so often:
  /// the above is of the whole walk.
  std::optional<std::uint32_t> events_below;
};

/// Light that a ray of the path has found by itself.
struct FoundLight {
  std::uint32_t light = no_light;  ///< Index into the scene's lights; no_light for all beyond the scene.
  Rgb radiance;
  float pdf = 0;     ///< Density of a light sample there, times their number, per solid angle; 0: of none.
  float weight = 1;  ///< By multiple importance sampling.
};

/// A sample of a light, at a surface.
struct TakenLightSample {
  std::uint32_t source = 0;  ///< One of LightSet::sampled().
  LightSample sample;
  Rgb scattered;   ///< f L |cos| times the weight; black where no shadow ray is needed.
  Rgb visibility;  ///< Black where something is in the way.
};

/// A direction of hemisphere sampling.
struct TakenDirection {
  Vec3 direction;                  ///< Unit, in world space.
  float pdf = 0;                   ///< Per solid angle.
  std::uint32_t light = no_light;  ///< What it has found, as FoundLight has it.
  Rgb radiance;
  Rgb scattered;  ///< f |cos|.
};

/// A term of the sample's radiance.
struct PathTerm {
  Rgb light;  ///< Throughput times light.
  Rgb term;   ///< The same where it is not clamped.
};

/// Whether the path goes on.
struct RouletteGame {
  float probability = 1;
  float draw = 0;  ///< The path goes on where it is less.
  Rgb throughput;  ///< Of a path that goes on.

  bool is_survived() const { return draw < probability; }
};

class PathObserver {
 public:
  virtual ~PathObserver() = default;
  virtual void arrived(const PathArrival&) {}
  virtual void stands_at(const Interaction&, Materials) {}
  /// What media on the way to the last arrival have emitted.
  virtual void passed_glow(const PathTerm&) {}
  virtual void found_light(const FoundLight&) {}
  virtual void sampled_light(const LightTransport&, const Interaction&, const TakenLightSample&) {}
  virtual void looked_around(const TakenDirection&) {}
  virtual void added(const PathTerm&) {}
  /// The numbers that scatter() was given, and what it made of them; null where the path ends.
  virtual void scattered(float /*lobe*/, Vec2 /*u*/, const Scattering*) {}
  virtual void played_roulette(const RouletteGame&) {}
};

}  // namespace twinray
