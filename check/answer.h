// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <bit>
#include <cstdint>

#include "accel/accelerator.h"

namespace twinray {

/// All that an engine says about a ray.
struct Answer {
  Hit closest;
  bool any = false;

  /// Whether both queries agree that there is a hit.
  bool is_consistent() const { return any == bool(closest); }
};

inline Answer ask(const Accelerator& engine, const Ray& ray) {
  const Hit closest = engine.closest_hit(ray);
  return {closest, engine.any_hit(ray)};
}

inline bool same_shape(const Hit& a, const Hit& b) {
  return a.primitive == b.primitive && a.mesh == b.mesh && a.instance == b.instance;
}

/// Equal bits; the ids and weights of two misses do not matter.
inline bool same_bits(const Hit& a, const Hit& b) {
  if (a.is_miss() || b.is_miss()) return a.is_miss() == b.is_miss();
  const auto bits = [](float x) { return std::bit_cast<std::uint32_t>(x); };
  return bits(a.t) == bits(b.t) && bits(a.u) == bits(b.u) && bits(a.v) == bits(b.v) && same_shape(a, b);
}
inline bool same_bits(const Answer& a, const Answer& b) {
  return a.any == b.any && same_bits(a.closest, b.closest);
}

}  // namespace twinray
