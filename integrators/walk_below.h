// SPDX-License-Identifier: Apache-2.0
// The way of a path below a surface (core/subsurface.h): from where it enters a body to where it comes out.
#pragma once
#include <cstdint>
#include <optional>

#include "core/interiors.h"
#include "core/sampler.h"
#include "core/scene.h"
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

/// Follows a ray into the body of a shape, whose medium is even, until it hits a surface of the body's
/// material again. Other surfaces within are passed straight on: what lies behind those that let light in is
/// around the body where the walk comes out there. None where it is absorbed. `body` is an index into the
/// scene's materials, as the shape has it.
std::optional<WalkEnd> walk_below(const Scene& scene, Tracer& tracer, const Interior& medium,
                                  std::uint32_t body, const WalkStart& start, const Rgb& throughput,
                                  const WalkDraws& draws);

}  // namespace twinray
