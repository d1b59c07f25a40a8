// SPDX-License-Identifier: Apache-2.0
// The lights of a scene, prepared for sampling.
#pragma once
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/aabb.h"
#include "core/distribution.h"
#include "core/environment.h"
#include "core/light_patch.h"
#include "core/light_sample.h"
#include "core/ray.h"
#include "core/scene.h"
#include "core/surface.h"

namespace twinray {

/// The points within a distance of a box.
struct Zone {
  Aabb box;
  float squared_distance = 0;  ///< 0: no point at all; infinity: all.

  bool contains(const Vec3& p) const {
    const auto beyond = [](float least, float x, float largest) {
      return std::max(std::max(least - x, x - largest), 0.0f);
    };
    const Vec3 between{beyond(box.lower.x, p.x, box.upper.x), beyond(box.lower.y, p.y, box.upper.y),
                       beyond(box.lower.z, p.z, box.upper.z)};
    return length_squared(between) < squared_distance;
  }
};

/// All lights of one scene; it keeps a reference to the scene's data, which must outlive it.
class LightSet {
 public:
  /// `compensation`: of the environments (core/environment.h), 0 where light samples alone find them.
  explicit LightSet(const Scene& scene, double compensation = 0);

  std::uint32_t size() const { return std::uint32_t(lights_.size()); }
  const Light& light(std::uint32_t index) const { return lights_[index]; }
  /// The triangles of a mesh light by their areas; empty for any other.
  const Distribution& triangles(std::uint32_t light) const { return triangles_[light]; }
  /// Whether the light is a point or a direction, which no ray can hit by chance: one sample is exact.
  bool is_delta(std::uint32_t light) const { return twinray::is_delta(lights_[light].source); }

  /// The patches of a mesh light that has few; none for any other.
  const PatchLight& patches(std::uint32_t light) const { return patches_[light]; }

  /// Where a light should be looked for by scattered directions as well, since its samples are chosen badly:
  /// close to a mesh light, whose nearest part brings most, and everywhere for an environment.
  const Zone& zone(std::uint32_t light) const { return zones_[light]; }
  /// Whether a point lies in the zone of any light.
  bool is_in_a_zone(const Vec3& position) const;

  /// Light of one source at a point that is lit on the side of `normal`, its unit shading normal; black where
  /// none of this sample can arrive. u in [0, 1)^2.
  LightSample sample(std::uint32_t light, const SurfacePoint& from, const Vec3& normal, Vec2 u) const;
  /// The density, per solid angle at `from`, with which sample() chooses the point of an emissive surface
  /// that a ray hits.
  float pdf(std::uint32_t light, const Receiver& from, const Hit& hit) const;
  /// The density, per solid angle, with which sample() chooses a unit direction towards a light that rays
  /// find by leaving the scene: one of distant(); 0 for all others.
  float pdf(std::uint32_t light, const Vec3& direction) const;

  /// Radiance that an emissive surface sends along the unit direction wo; black for all other surfaces.
  Rgb emitted(const SurfacePoint& point, const Vec3& wo) const;
  /// The lights that a ray which leaves the scene may find, in their order.
  std::span<const std::uint32_t> distant() const { return distant_; }
  /// Radiance of one of them along a unit direction towards it; black for all others.
  Rgb radiance(std::uint32_t light, const Vec3& direction) const;
  /// Radiance that a bounce ray brings when it leaves the scene along a unit direction.
  Rgb escaped(const Vec3& direction) const;
  /// Radiance that a camera ray brings then: of environments; an ambient light is not seen.
  Rgb background(const Vec3& direction) const;

 private:
  std::span<const Light> lights_;
  std::span<const ShapeBinding> bindings_;
  const Geometry& geometry_;
  // One for each light:
  std::vector<Distribution> triangles_;  ///< By area, empty where it is not a mesh.
  std::vector<PatchLight> patches_;
  std::vector<Zone> zones_;
  std::vector<std::uint32_t> environment_of_;  ///< Which of environments_; of no meaning for other lights.
  std::vector<Environment> environments_;
  std::vector<std::uint32_t> distant_;
};

}  // namespace twinray
