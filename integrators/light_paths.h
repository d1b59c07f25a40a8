// SPDX-License-Identifier: Apache-2.0
// The light of a picture by the paths that it took: which part of it a term of the radiance belongs to.
//
// What the camera sees directly is emission, or environment. All else is divided by how the first surface
// scattered it: the matte part of the surface (diffuse), its highlights and mirrors (glossy), or the way
// through it (transmission); and by whether it came there from a light (direct) or from another surface.
#pragma once
#include <algorithm>
#include <cstddef>
#include <span>

#include "core/record.h"
#include "integrators/direct_light.h"
#include "integrators/interaction.h"

namespace twinray {

/// How a path was scattered at its first surface.
struct FirstScattering {
  Rgb diffuse{1, 1, 1};  ///< The part of its light that the matte part of the surface scattered.
  bool is_transmitted = false;
  /// Whether the matte part is all that did.
  bool is_diffuse() const { return !is_transmitted && diffuse == Rgb{1, 1, 1}; }
};

/// Of a path that leaves in a direction.
inline FirstScattering first_scattering(const Interaction& at, const Vec3& wi, Seeking seeking) {
  if (at.is_lambert()) return {};
  return {seeking == Seeking::alone ? Rgb{} : at.diffuse_share(wi), at.transmits(wi)};
}

/// The light of one sample by its paths.
class PathParts {
 public:
  explicit PathParts(std::span<Rgb> parts) : parts_(parts) {}
  Rgb& operator[](LightPath path) const { return parts_[std::size_t(path)]; }

 private:
  std::span<Rgb> parts_;  ///< light_path_count of them.
};

/// Adds what the camera sees directly.
inline void add_seen_light(bool is_miss, const Rgb& term, const PathParts& parts) {
  parts[is_miss ? LightPath::environment : LightPath::emission] += term;
}

/// Adds a term of light that was scattered `depth` times, 1 or more.
inline void add_scattered_light(const FirstScattering& first, const Rgb& term, int depth,
                                const PathParts& parts) {
  using enum LightPath;
  const bool is_direct = depth == 1;
  if (first.is_diffuse()) {
    parts[is_direct ? diffuse_direct : diffuse_indirect] += term;
    return;
  }
  if (is_black(term)) return;
  if (first.is_transmitted) {
    parts[is_direct ? transmission_direct : transmission_indirect] += term;
    return;
  }
  const Rgb diffuse = term * first.diffuse;
  parts[is_direct ? diffuse_direct : diffuse_indirect] += diffuse;
  parts[is_direct ? glossy_direct : glossy_indirect] += term - diffuse;
}

/// Adds direct light at the first surface, which scattered it so.
inline void add_direct_light(const Rgb& throughput, const ScatteredLight& scattered, const Rgb& term,
                             const PathParts& parts) {
  const Rgb diffuse = throughput * scattered.diffuse, transmitted = throughput * scattered.transmitted;
  const Rgb glossy = term - diffuse - transmitted;
  parts[LightPath::diffuse_direct] += diffuse;
  parts[LightPath::transmission_direct] += transmitted;
  parts[LightPath::glossy_direct] +=
      {std::max(0.0f, glossy.r), std::max(0.0f, glossy.g), std::max(0.0f, glossy.b)};
}

}  // namespace twinray
