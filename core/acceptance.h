// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/hit.h"
#include "core/vec.h"

namespace twinray {

class Geometry;

/// Whether a hit counts, of shapes that have holes. A pure function of ray and hit: so the least hit that
/// counts is the same in whatever order a tree finds them.
class Acceptance {
 public:
  virtual ~Acceptance() = default;
  /// Asked about hits of shapes that are not opaque, from any thread. Of an instance the ray is given in the
  /// space of its prototype. The direction may be the ray's times a power of two; the hit's t has no meaning.
  virtual bool accepts(const Geometry& geometry, const Vec3& origin, const Vec3& direction,
                       const Hit& hit) const noexcept = 0;
};

}  // namespace twinray
