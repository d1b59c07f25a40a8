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
#include "core/light_tree.h"
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

/// Whether a light has a shape of which alpha leaves nothing: it shines, and no ray hits it.
bool is_invisible(const Scene& scene, const LightSource& source);

/// How a scene's lights are sampled where it has more than a few.
enum class ManyLights {
  tree,   ///< One is chosen, by what it may bring to the surface (core/light_tree.h).
  power,  ///< One is chosen, by its power alone.
  all,    ///< Each of them is sampled.
};

struct LightSetOptions {
  double compensation =
      0;  ///< Of the environments (core/environment.h), 0 where light samples alone find them.
  ManyLights many = ManyLights::tree;
};

/// All lights of one scene; it keeps a reference to the scene's data, which must outlive it.
class LightSet {
 public:
  explicit LightSet(const Scene& scene, const LightSetOptions& options = {});

  std::uint32_t size() const { return std::uint32_t(lights_.size()); }
  const Light& light(std::uint32_t index) const { return lights_[index]; }

  /// More lights than these of one kind (such that have a surface; points) are sampled as a group.
  static constexpr std::size_t most_alone = 8;
  /// Lights that are chosen from.
  struct Group {
    std::vector<std::uint32_t> lights;
    LightTree tree;
  };
  /// That of a number behind those of all lights.
  const Group& group(std::uint32_t number) const { return groups_[number - size()]; }

  /// What is sampled at a surface: lights, and groups, whose numbers follow those of all lights. A sample of
  /// a group is one of one of its lights.
  std::span<const std::uint32_t> sampled() const { return sampled_; }
  /// The mesh light of this number; null for another light and for a group.
  const MeshLight* mesh(std::uint32_t light) const {
    return light < size() ? std::get_if<MeshLight>(&lights_[light].source) : nullptr;
  }
  /// The triangles of a mesh light by their areas; empty for any other.
  const Distribution& triangles(std::uint32_t light) const { return triangles_[light]; }
  /// Whether the light is a point, a direction or an invisible shape, which no ray can hit by chance: one
  /// sample is enough.
  bool is_delta(std::uint32_t light) const {
    if (light >= size()) return light == size() + points;
    return twinray::is_delta(lights_[light].source) || is_invisible_[light];
  }

  /// Whether there is less of the light's shape than its geometry (core/alpha_test.h), and so of its light.
  bool has_alpha(std::uint32_t light) const { return alphas_[light] != no_texture; }

  /// Of an environment light; null for another light and for a group.
  const Environment* environment(std::uint32_t light) const {
    const bool is_one = light < size() && std::holds_alternative<EnvironmentLight>(lights_[light].source);
    return is_one ? &environments_[environment_of_[light]] : nullptr;
  }
  /// The patches of a mesh light that has few; none for any other.
  const PatchLight& patches(std::uint32_t light) const { return patches_[light]; }

  /// Where a light should be looked for by scattered directions as well, since its samples are chosen badly:
  /// close to a mesh light, whose nearest part brings most, and everywhere for an environment.
  const Zone& zone(std::uint32_t light) const { return zones_[light]; }
  /// Whether a point lies in the zone of any light.
  bool is_in_a_zone(const Vec3& position) const;

  /// Light of one source at a point, which is the receiver; black where none of this sample can arrive. u in
  /// [0, 1)^2.
  LightSample sample(std::uint32_t light, const SurfacePoint& from, const Receiver& receiver, Vec2 u) const;
  /// How much the draw that chooses from a group lies behind u.x: below its 24 bits, so that enough is left
  /// of it for a point on the light.
  static float finer_bits(Vec2 u);
  /// A sample of a group by what is left of the draws, once one of its lights is chosen with a probability >
  /// 0.
  LightSample sample_chosen(std::uint32_t light, float probability, const SurfacePoint& from,
                            const Receiver& receiver, Vec2 u) const;
  /// The light that a sample comes from: of a group of lights, the one that was chosen.
  std::uint32_t source(std::uint32_t light, std::uint32_t chosen) const {
    return light < size() ? light : chosen;
  }
  /// The density, per solid angle at `from`, with which sample() chooses the point of an emissive surface
  /// that a ray hits.
  float pdf(std::uint32_t light, const Receiver& from, const Hit& hit) const {
    const float alone = pdf_alone(light, from, hit);
    return group_of_[light] == no_group ? alone : alone * probability_in_group(light, from);
  }
  /// The density, per solid angle, with which sample() chooses a unit direction towards a light that rays
  /// find by leaving the scene: one of distant(); 0 for all others.
  float pdf(std::uint32_t light, const Vec3& direction) const;

  /// Radiance that an emissive surface sends along the unit direction wo; black for all other surfaces.
  Rgb emitted(const SurfacePoint& point, const Vec3& wo) const;
  /// The lights that a ray which leaves the scene may find, in their order.
  std::span<const std::uint32_t> distant() const { return distant_; }
  /// Radiance of one of them along a unit direction towards it; black for all others.
  Rgb radiance(std::uint32_t light, const Vec3& direction) const;
  /// What a ray along a unit direction finds of one of them: radiance and pdf(light, direction).
  Environment::View view(std::uint32_t light, const Vec3& direction) const;
  /// For each of several unit directions the views of all of distant(), in their order.
  void view(std::span<const Vec3> directions, std::span<Environment::View> views) const;
  /// Radiance that a bounce ray brings when it leaves the scene along a unit direction.
  Rgb escaped(const Vec3& direction) const;
  /// Radiance that a camera ray brings then: of environments; an ambient light is not seen.
  Rgb background(const Vec3& direction) const;
  /// radiances[i] = background(directions[i]), many at a time.
  void background(std::span<const Vec3> directions, std::span<Rgb> radiances) const;

 private:
  static constexpr std::uint32_t surfaces = 0, points = 1, no_group = 2;  ///< Indices into groups_.

  void prepare(std::uint32_t light, double compensation);
  void make_groups(ManyLights many);
  LightSample sample_group(const Group& group, const SurfacePoint& from, const Receiver& receiver,
                           Vec2 u) const;
  float alpha_of(std::uint32_t light, const Hit& hit) const;
  float pdf_alone(std::uint32_t light, const Receiver& from, const Hit& hit) const;
  float probability_in_group(std::uint32_t light, const Receiver& from) const;

  std::span<const Light> lights_;
  std::span<const ShapeBinding> bindings_;
  std::span<const Texture> textures_;
  const Geometry& geometry_;
  // One for each light:
  std::vector<Distribution> triangles_;  ///< By area, empty where it is not a mesh.
  std::vector<std::uint32_t> alphas_;    ///< The textures that cut their shapes out, if any.
  std::vector<bool> is_invisible_;       ///< Their alpha is 0 everywhere.
  std::vector<PatchLight> patches_;
  std::vector<Zone> zones_;  ///< And one for each group.
  std::vector<std::uint32_t> group_of_, place_in_group_;
  std::vector<std::uint32_t> environment_of_;  ///< Which of environments_; of no meaning for other lights.
  std::vector<Environment> environments_;
  std::vector<std::uint32_t> distant_;
  Group groups_[2];
  std::vector<std::uint32_t> sampled_;
  bool is_all_a_zone_ = false;
};

}  // namespace twinray
