// SPDX-License-Identifier: Apache-2.0
// The way of a path below a surface (core/subsurface.h): from where it enters a body to where it comes out.
#pragma once
#include <cstdint>
#include <optional>

#include "core/interiors.h"
#include "core/phase_function.h"
#include "core/sampler.h"
#include "core/scene.h"
#include "integrators/flight.h"
#include "integrators/tracer.h"

namespace twinray {

/// The draws of a walk below one vertex of a path, and those at its end: of vertices that no path has itself.
class WalkDraws {
 public:
  /// A walk of so many steps comes out where it went in.
  static constexpr std::uint32_t most_steps = 1 << 12;

  /// Below this vertex, as VertexSampler counts them.
  WalkDraws(SamplerKind kind, const PathKey& path, std::uint32_t vertex)
      : kind_(kind), path_(path), first_((vertex + 1) * (2 * most_steps)) {}

  /// Of a step, less than most_steps.
  VertexSampler at(std::uint32_t step) const { return {kind_, path_, first_ + 1 + step}; }
  /// Where the walk comes out.
  VertexSampler at_end() const { return {kind_, path_, first_ + most_steps + 1}; }

 private:
  SamplerKind kind_;
  PathKey path_;
  std::uint32_t first_;
};

/// Where a walk begins.
struct WalkStart {
  Ray into;
  float way = 0;  ///< From the surface to the ray's origin, which is moved off it.
  Interiors interiors = {};
  /// What comes back where the walk went in, if its first ray meets nothing: that is no way into a body.
  /// None: then the body has no end there.
  std::optional<Rgb> left_if_open = {};
};

/// Where a walk has come out.
struct WalkEnd {
  Ray ray;                   ///< The last one, from inside,
  Hit hit;                   ///< and what it hits; a miss where the walk comes out where it went in.
  Rgb left;                  ///< Of the path's throughput.
  Interiors interiors;       ///< That the path is in.
  float eta_squared = 1;     ///< Of its index of refraction, to that where the walk went in.
  std::uint32_t events = 0;  ///< How often it was scattered.
};

/// The least radius of a walk: that many times the offset by which rays leave the surface there. What goes no
/// further below is reflected where it is, else rounding would decide where a walk comes out.
inline constexpr float least_radius = 64;

/// What a walk is in.
struct BodyBelow {
  Interior medium;  ///< Even.
  std::uint32_t material =
      0;  ///< Of the body's surfaces: an index into the scene's materials, as shapes have it.
};

/// The walk of a path in a body, ray by ray, until it hits a surface of the body again. Other surfaces within
/// are passed straight on: what lies behind those that let light in is around the body where the walk comes
/// out there.
class WalkBelow {
 public:
  /// The scene must outlive it. `throughput` is that of the path where the walk begins.
  WalkBelow(const Scene& scene, const BodyBelow& body, const WalkStart& start, const Rgb& throughput,
            const WalkDraws& draws);

  /// Along which the walk goes on, as far as it does before it is scattered: what it hits is asked for next.
  const Ray& ray() const { return ray_; }
  /// Goes on by what that ray hits; false where the walk ends.
  bool goes_on(const Hit& hit);
  /// Where the walk has come out; none while it goes on, and where it was absorbed.
  const std::optional<WalkEnd>& end() const { return end_; }

 private:
  /// Finds how far the walk goes along the next ray.
  void take_off();
  /// False: so the walk ends.
  bool comes_out();
  bool comes_back();
  /// To where the path is scattered, `distance` behind the ray's beginning.
  void scatter(float distance, Vec2 u);

  const Scene* scene_;
  BodyBelow body_;
  WalkStart start_;
  Rgb throughput_;
  WalkDraws draws_;
  PhaseFunction phase_;
  WalkEnd walk_;
  std::optional<Flight> flight_;  ///< Along the current ray,
  Ray ray_;                       ///< of which this is needed.
  std::optional<WalkEnd> end_;
  float before_;  ///< Of the way in the body, what is before the ray's beginning.
  std::uint32_t step_ = 0;
};

/// A walk to its end.
std::optional<WalkEnd> walk_below(Tracer& tracer, WalkBelow walk);

}  // namespace twinray
