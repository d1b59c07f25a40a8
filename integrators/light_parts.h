// SPDX-License-Identifier: Apache-2.0
// The light of a picture by the paths that it took: which part of the colours a term of the radiance belongs
// to.
//
// What the camera sees directly is emission, or environment. All else is divided by how the first surface
// scattered it: the matte part of the surface (diffuse), its highlights and mirrors (glossy), or the way
// through it (transmission); and by whether it came there from a light (direct) or from another surface.
#pragma once
#include <algorithm>
#include <cstddef>

#include "core/record.h"
#include "integrators/direct_light.h"
#include "integrators/interaction.h"

namespace twinray {

inline bool shows_light_parts(const RecordSpans& records) { return records.has(Layer::emission); }

/// How a path was scattered at its first surface.
struct FirstScattering {
  Rgb diffuse{1, 1, 1};  ///< The part of its light that the matte part of the surface scattered.
  bool is_transmitted = false;
};

/// Of a path that leaves in a direction.
inline FirstScattering first_scattering(const Interaction& at, const Vec3& wi, Seeking seeking) {
  if (at.is_lambert()) return {};
  return {seeking == Seeking::alone ? Rgb{} : at.diffuse_share(wi), at.to_local(wi).z < 0};
}

/// Adds what the camera sees directly.
inline void add_seen_light(bool is_miss, const Rgb& term, const RecordSpans& records, std::size_t sample) {
  records[is_miss ? Layer::environment : Layer::emission][sample] += term;
}

/// Adds a term of light that was scattered `depth` times, 1 or more.
inline void add_scattered_light(const FirstScattering& first, const Rgb& term, int depth,
                                const RecordSpans& records, std::size_t sample) {
  if (is_black(term)) return;
  const bool is_direct = depth == 1;
  if (first.is_transmitted) {
    records[is_direct ? Layer::transmission_direct : Layer::transmission_indirect][sample] += term;
    return;
  }
  const Rgb diffuse = term * first.diffuse;
  records[is_direct ? Layer::diffuse_direct : Layer::diffuse_indirect][sample] += diffuse;
  records[is_direct ? Layer::glossy_direct : Layer::glossy_indirect][sample] += term - diffuse;
}

/// Adds direct light at the first surface, of which these are parts.
inline void add_direct_light(const Interaction& at, const Rgb& throughput, const DirectParts& parts,
                             const Rgb& term, const RecordSpans& records, std::size_t sample) {
  if (at.is_lambert()) return add_scattered_light({}, term, 1, records, sample);
  const Rgb diffuse = throughput * parts.diffuse, transmitted = throughput * parts.transmitted;
  const Rgb glossy = term - diffuse - transmitted;
  records[Layer::diffuse_direct][sample] += diffuse;
  records[Layer::transmission_direct][sample] += transmitted;
  records[Layer::glossy_direct][sample] +=
      {std::max(0.0f, glossy.r), std::max(0.0f, glossy.g), std::max(0.0f, glossy.b)};
}

}  // namespace twinray
