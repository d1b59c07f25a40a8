// SPDX-License-Identifier: Apache-2.0
// Private: rays that go on from one hit to the next, such as PassingRay and WalkBelow, many together.
#pragma once
#include <cstdint>
#include <vector>

#include "integrators/tracer.h"

namespace twinray {

/// Where rays and their hits are kept meanwhile.
struct FollowedRays {
  std::vector<Ray>& rays;
  std::vector<Hit>& hits;
};

/// Traces the rays of these numbers, which are in order, again and again: `of(n).ray()` for as long as
/// `of(n).goes_on(hit)`. `going` is empty then.
template <typename Of>
void follow_together(Tracer& tracer, RayKind kind, const Of& of, std::vector<std::uint32_t>& going,
                     const FollowedRays& room) {
  while (!going.empty()) {
    room.rays.clear();
    for (const std::uint32_t n : going) room.rays.push_back(of(n).ray());
    room.hits.resize(going.size());
    tracer.hits(room.rays, kind, room.hits);
    std::size_t kept = 0;
    for (std::size_t k = 0; k < going.size(); ++k) {
      going[kept] = going[k];
      kept += of(going[k]).goes_on(room.hits[k]);
    }
    going.resize(kept);
  }
}

}  // namespace twinray
