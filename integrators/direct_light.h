// SPDX-License-Identifier: Apache-2.0
// Direct light: the light that emitters send to a surface and that it scatters to the viewer.
#pragma once
#include <cstdint>

#include "core/light_set.h"
#include "core/sampler.h"
#include "integrators/interaction.h"
#include "integrators/light_groups.h"
#include "integrators/passages.h"
#include "integrators/tracer.h"

namespace twinray {

enum class DirectMethod {
  mis,     ///< As by lights; within a light's zone (core/light_set.h) scattered rays that hit it count, too.
  lights,  ///< Points of the lights are sampled.
  hemisphere,  ///< Directions are sampled, uniformly; the emitters that they hit count. Never hits a delta
               ///< light.
};

/// Everything a light estimate needs besides the point: constant while a scene is rendered.
struct LightTransport {
  const Scene& scene;
  const LightSet& lights;
  DirectMethod method = DirectMethod::mis;
  std::uint32_t samples_per_light = 1;  ///< For each light that is not a delta light; >= 1.
  const Passages* passages = nullptr;   ///< Of the scene, if it has any.
  bool has_glow = false;                ///< Of the scene: media emit light, which rays find on their way.

  /// How many samples a light gets.
  std::uint32_t samples_of(std::uint32_t light) const {
    return lights.is_delta(light) ? 1 : samples_per_light;
  }
  /// How many directions hemisphere sampling takes.
  std::uint32_t directions() const { return std::uint32_t(lights.sampled().size()) * samples_per_light; }
};

/// How much the environments' samples leave to scattered rays (core/environment.h).
inline double compensation_for(DirectMethod method, std::uint32_t samples_per_light) {
  return method == DirectMethod::mis ? mis_compensation(samples_per_light) : 0;
}

/// Which light a scattered ray is to bring from a surface.
enum class Seeking {
  zones,  ///< By mis: of lights in whose zones the surface is. A Lambert surface scatters evenly: of others,
          ///< light samples bring most.
  all,    ///< By mis: of all lights, since the surface may scatter most from a few directions.
  alone,  ///< By all methods: all light, since no sample of a light has the direction of a mirror.
};

/// Where a scattered ray comes from, and how likely it was.
struct Departure {
  Receiver from;
  float pdf = 1;  ///< Of its direction, per solid angle; no meaning for one that seeks alone.
  Seeking seeking = Seeking::zones;
};

/// A direction in which hemisphere sampling looks for emitters.
struct Look {
  Vec3 direction;     ///< Unit, in world space.
  float density = 1;  ///< Per solid angle, relative to uniform_hemisphere_pdf().
};
/// Uniform in the hemisphere of a Lambert surface; all around others, which may let light through. u in
/// [0, 1)^2.
Look look_around(const Interaction& at, Vec2 u);

/// The part of a light's sample that scattered rays do not find, which have its direction with the density
/// `scattered_pdf`.
float light_sample_weight(const LightTransport& transport, std::uint32_t light, const Interaction& at,
                          const LightSample& sample, float scattered_pdf);

/// What a surface scatters of a light's sample before its visibility and density, but for the part that
/// scattered rays find. What interiors absorb on the way counts here, but where there are passages: then it
/// belongs to the visibility.
Rgb scattered_sample(const LightTransport& transport, std::uint32_t light, const Interaction& at,
                     const LightSample& sample);

/// Direct light of a surface that is not Lambert's by how that scattered it; the rest is glossy.
struct ScatteredLight {
  Rgb diffuse, transmitted;

  /// Adds light that is scattered from a direction, in world space.
  void add(const Interaction& at, const Vec3& wi, const Rgb& light);
};

/// What is asked for of direct light besides its sum.
struct LightShares {
  ScatteredLight* scattered = nullptr;
  LightGroups groups;
};

/// An estimate of the light of all emitters, scattered once at a surface into all but delta directions; by
/// `hemisphere`, of all but delta lights; by `mis`, but for the part that scattered rays find. Unbiased.
Rgb direct_light(const LightTransport& transport, const Interaction& at, const VertexSampler& sampler,
                 Tracer& tracer, const LightShares& shares = {});

/// The ray along which a path goes on.
struct Arrival {
  const Hit& hit;
  Vec3 direction;  ///< Unit.
  /// Of one that misses: its views of the distant lights, in their order, where they are known already.
  std::span<const Environment::View> views = {};
};

/// What is left out there, by the ray that a path goes on along.
Rgb found_light(const LightTransport& transport, const Departure& departure, const Arrival& arrival,
                PathObserver& observer, const LightGroups& groups = {});
/// Whether a ray from there could find any.
bool may_find_light(const LightTransport& transport, const Departure& departure);

/// The light that a ray has found by its hit, as FoundLight has it.
std::uint32_t light_at(const Scene& scene, const Hit& hit);
/// Calls `take(light, radiance)` for what a ray brings of each light: from an emitter that it hits, or from
/// those beyond the scene.
template <typename Take>
void for_each_lamp(const LightTransport& transport, const Arrival& arrival, const Take& take) {
  const LightSet& lights = transport.lights;
  const Vec3& direction = arrival.direction;
  if (!arrival.hit.is_miss()) {
    if (const std::uint32_t light = light_at(transport.scene, arrival.hit); light != no_light)
      take(light, lights.emitted(surface_at(*transport.scene.geometry, arrival.hit), -direction));
    return;
  }
  for (std::size_t place = 0; place < lights.distant().size(); ++place) {
    const std::uint32_t light = lights.distant()[place];
    take(light, arrival.views.empty() ? lights.radiance(light, direction) : arrival.views[place].radiance);
  }
}
/// The sum of it.
Rgb lamp_radiance(const LightTransport& transport, const Hit& hit, const Vec3& direction);
/// What a camera ray brings of them by groups: it does not see ambient lights.
void add_seen_groups(const LightTransport& transport, const Arrival& arrival, const LightGroups& groups);

}  // namespace twinray
