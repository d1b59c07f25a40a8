// SPDX-License-Identifier: Apache-2.0
// The way of a path below a surface (core/subsurface.h): from where it enters a body to where it comes out.
#pragma once
#include <cstdint>
#include <optional>

#include "core/sampler.h"
#include "core/scene.h"
#include "integrators/tracer.h"

namespace twinray {

/// The draws of a walk below one vertex of a path, and those at its end: of vertices that no path has itself.
class WalkDraws {
 public:
  /// Walks longer than that end where they are.
  static constexpr std::uint32_t most_events = 1 << 14;

  /// Below this vertex, as VertexSampler counts them.
  WalkDraws(SamplerKind kind, const PathKey& path, std::uint32_t vertex)
      : kind_(kind), path_(path), first_((vertex + 1) * (2 * most_events)) {}

  /// Of an event, less than most_events.
  VertexSampler at(std::uint32_t event) const { return {kind_, path_, first_ + 1 + event}; }
  /// Where the walk comes out.
  VertexSampler at_end() const { return {kind_, path_, first_ + most_events + 1}; }

 private:
  SamplerKind kind_;
  PathKey path_;
  std::uint32_t first_;
};

/// Where a walk has come out.
struct WalkEnd {
  Ray ray;                   ///< The last one, from inside,
  Hit hit;                   ///< and what it hits.
  Rgb left;                  ///< Of the path's throughput.
  std::uint32_t events = 0;  ///< How often it was scattered.
};

/// Follows a ray into the body of a shape, whose medium is even, until it hits a surface of the body's
/// material again; other surfaces within are passed. None where it does not come out: it is absorbed, or the
/// body is not closed. `body` is an index into the scene's materials, as the shape has it.
std::optional<WalkEnd> walk_below(const Scene& scene, Tracer& tracer, const Interior& medium,
                                  std::uint32_t body, const Ray& into, const Rgb& throughput,
                                  const WalkDraws& draws);

}  // namespace twinray
