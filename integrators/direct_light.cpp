// SPDX-License-Identifier: Apache-2.0
#include "integrators/direct_light.h"

#include "core/mis.h"
#include "core/spawn_ray.h"
#include "core/warp.h"

namespace twinray {
namespace {

Rgb sample_hemisphere(const LightTransport& transport, const Interaction& at, const VertexSampler& sampler,
                      Tracer& tracer, const LightShares& shares) {
  const std::uint32_t count = transport.directions();
  const float divisor = float(count) * uniform_hemisphere_pdf();
  Rgb sum;
  for (std::uint32_t part = 0; part < count; ++part) {
    const Look look = look_around(at, sampler.draw_2d(Purpose::light_point, {part, count, 0}));
    const Rgb scattered = at.scattered(look.direction).value;
    if (is_black(scattered)) continue;
    const Ray ray = spawn_ray(at.point(), look.direction);
    Way way{ray, tracer.bounce_hit(ray), at.interiors(look.direction)};
    if (transport.passages) transport.passages->follow(tracer, way);
    const Hit& hit = way.hit;
    const Rgb passed = way.left * transmittance(transport.scene, way.interiors, way.ray, hit.t);
    const Rgb found = lamp_radiance(transport, hit, look.direction) * passed;
    const Rgb light = scattered * found / look.density;
    sum += light;
    if (shares.scattered) shares.scattered->add(at, look.direction, light / divisor);
    if (shares.groups.are_kept())
      for_each_lamp(transport, {hit, look.direction}, [&](std::uint32_t lamp, const Rgb& radiance) {
        shares.groups.add(lamp, scattered * (radiance * passed) / look.density / divisor);
      });
    tracer.observer().looked_around({look.direction, look.density * uniform_hemisphere_pdf(),
                                     light_at(transport.scene, hit), found, scattered});
  }
  return count == 0 ? Rgb{} : sum / divisor;
}

/// What comes along a shadow ray; where there are no passages it is all, or nothing.
Rgb visibility(const LightTransport& transport, const Interaction& at, const LightSample& sample,
               Tracer& tracer) {
  if (!transport.passages) return tracer.visibility(sample.shadow_ray);
  return transport.passages->visibility(tracer, sample.shadow_ray, at.interiors(sample.direction));
}

/// The light of one source, by the mean of its samples.
Rgb sample_light(const LightTransport& transport, std::uint32_t light, const Interaction& at,
                 const VertexSampler& sampler, Tracer& tracer, const LightShares& shares) {
  const std::uint32_t count = transport.samples_of(light);
  Rgb sum;
  for (std::uint32_t part = 0; part < count; ++part) {
    const Vec2 u = sampler.draw_2d(Purpose::light_point, {part, count, light});
    const LightSample sample = transport.lights.sample(light, at.point(), at.receiver(), u);
    const Rgb scattered = scattered_sample(transport, light, at, sample);
    const Rgb visible = is_black(scattered) ? Rgb{} : visibility(transport, at, sample, tracer);
    if (!is_black(scattered)) {
      const Rgb light_there = scattered * visible / sample.pdf;
      sum += light_there;
      if (shares.scattered) shares.scattered->add(at, sample.direction, light_there / float(count));
      shares.groups.add(transport.lights.source(light, sample.light), light_there / float(count));
    }
    tracer.observer().sampled_light(transport, at, {light, sample, scattered, visible});
  }
  return sum / float(count);
}

bool is_sought(const LightSet& lights, const Departure& departure, std::uint32_t light) {
  return departure.seeking == Seeking::all || lights.zone(light).contains(departure.from.position);
}

/// Light of which no light sample brings any.
Rgb found_alone(const LightTransport& transport, const Arrival& arrival, PathObserver& observer,
                const LightGroups& groups) {
  Rgb radiance;
  for_each_lamp(transport, arrival, [&](std::uint32_t lamp, const Rgb& from_lamp) {
    radiance += from_lamp;
    groups.add(lamp, from_lamp);
  });
  observer.found_light({.light = light_at(transport.scene, arrival.hit), .radiance = radiance});
  return radiance;
}

}  // namespace

void ScatteredLight::add(const Interaction& at, const Vec3& wi, const Rgb& light) {
  if (at.transmits(wi))
    transmitted += light;
  else
    diffuse += light * at.diffuse_share(wi);
}

float light_sample_weight(const LightTransport& transport, std::uint32_t light, const Interaction& at,
                          const LightSample& sample, float scattered_pdf) {
  if (transport.method != DirectMethod::mis || transport.lights.is_delta(light)) return 1;
  if (at.is_lambert() && !transport.lights.zone(light).contains(at.point().position)) return 1;
  return power_heuristic(float(transport.samples_of(light)) * sample.pdf, scattered_pdf);
}

Look look_around(const Interaction& at, Vec2 u) {
  if (at.is_lambert()) return {at.to_world(square_to_uniform_hemisphere(u))};
  return {at.to_world(square_to_uniform_sphere(u)), uniform_sphere_pdf() / uniform_hemisphere_pdf()};
}

Rgb scattered_sample(const LightTransport& transport, std::uint32_t light, const Interaction& at,
                     const LightSample& sample) {
  if (is_black(sample.radiance)) return {};
  const BsdfValue scattered = at.scattered(sample.direction);
  const Rgb arriving = transport.passages ? Rgb{1, 1, 1}
                                          : transmittance(transport.scene, at.interiors(sample.direction),
                                                          sample.shadow_ray, sample.shadow_ray.t_max);
  return scattered.value * sample.radiance *
         light_sample_weight(transport, light, at, sample, scattered.pdf) * arriving;
}

Rgb direct_light(const LightTransport& transport, const Interaction& at, const VertexSampler& sampler,
                 Tracer& tracer, const LightShares& shares) {
  if (transport.method == DirectMethod::hemisphere)
    return sample_hemisphere(transport, at, sampler, tracer, shares);
  Rgb sum;
  for (const std::uint32_t light : transport.lights.sampled())
    sum += sample_light(transport, light, at, sampler, tracer, shares);
  return sum;
}

Rgb found_light(const LightTransport& transport, const Departure& departure, const Arrival& arrival,
                PathObserver& observer, const LightGroups& groups) {
  if (departure.seeking == Seeking::alone) return found_alone(transport, arrival, observer, groups);
  if (transport.method != DirectMethod::mis) return {};
  const LightSet& lights = transport.lights;
  const Hit& hit = arrival.hit;
  const Vec3& direction = arrival.direction;
  const float count = float(transport.samples_per_light);
  const auto weighted = [&](std::uint32_t light, const Rgb& radiance, float pdf) {
    const FoundLight found{light, radiance, count * pdf, power_heuristic(departure.pdf, count * pdf)};
    observer.found_light(found);
    groups.add(light, found.radiance * found.weight);
    return found.radiance * found.weight;
  };
  if (hit.is_miss()) {
    Rgb sum;
    for (std::size_t place = 0; place < lights.distant().size(); ++place) {
      const std::uint32_t light = lights.distant()[place];
      if (!is_sought(lights, departure, light)) continue;
      const auto [radiance, pdf] =
          arrival.views.empty() ? lights.view(light, direction) : arrival.views[place];
      sum += weighted(light, radiance, pdf);
    }
    return sum;
  }
  const std::uint32_t light = transport.scene.bindings[hit.mesh].light;
  if (light == no_light || !is_sought(lights, departure, light)) return {};
  return weighted(light, lights.emitted(surface_at(*transport.scene.geometry, hit), -direction),
                  lights.pdf(light, departure.from, hit));
}

bool may_find_light(const LightTransport& transport, const Departure& departure) {
  if (departure.seeking == Seeking::alone || transport.has_glow) return true;
  if (transport.method != DirectMethod::mis) return false;
  return departure.seeking == Seeking::all || transport.lights.is_in_a_zone(departure.from.position);
}

std::uint32_t light_at(const Scene& scene, const Hit& hit) {
  return hit.is_miss() ? no_light : scene.bindings[hit.mesh].light;
}

Rgb lamp_radiance(const LightTransport& transport, const Hit& hit, const Vec3& direction) {
  if (hit.is_miss()) return transport.lights.escaped(direction);
  if (transport.scene.bindings[hit.mesh].light == no_light) return {};
  return transport.lights.emitted(surface_at(*transport.scene.geometry, hit), -direction);
}

void add_seen_groups(const LightTransport& transport, const Arrival& arrival, const LightGroups& groups) {
  if (!groups.are_kept()) return;
  for_each_lamp(transport, arrival, [&](std::uint32_t lamp, const Rgb& radiance) {
    const bool is_seen = !arrival.hit.is_miss() || is_background(transport.lights.light(lamp).source);
    if (is_seen) groups.add(lamp, radiance);
  });
}

}  // namespace twinray
