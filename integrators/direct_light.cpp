// SPDX-License-Identifier: Apache-2.0
#include "integrators/direct_light.h"

#include "core/offset.h"
#include "core/warp.h"

namespace twinray {
namespace {

/// f L |cos| / p of one sample of one light (solid angle measure), if nothing is in the way.
Rgb light_sample(const LightTransport& transport, std::uint32_t light, const Interaction& at, Vec2 u,
                 Tracer& tracer) {
  const auto sample = transport.lights.sample(light, at.point(), u);
  if (!sample) return {};
  const Rgb scattered = at.scattered(sample->direction) * sample->radiance;
  if (is_black(scattered)) return {};
  return scattered * tracer.visibility(sample->connection) / sample->pdf;
}

Rgb sample_lights(const LightTransport& transport, const Interaction& at, VertexSampler& sampler,
                  Tracer& tracer) {
  Rgb sum;
  for (std::uint32_t light = 0; light < transport.lights.size(); ++light) {
    const std::uint32_t parts = transport.lights.is_delta(light) ? 1 : transport.samples_per_light;
    Rgb of_light;
    for (std::uint32_t part = 0; part < parts; ++part) {
      const Vec2 u = sampler.draw_2d(Purpose::light_point, part, parts, light);
      of_light += light_sample(transport, light, at, u, tracer);
    }
    sum += of_light / float(parts);
  }
  return sum;
}

/// Radiance that arrives from a direction straight from a lamp.
Rgb lamp_radiance(const LightTransport& transport, const Interaction& at, const Vec3& direction,
                  Tracer& tracer) {
  const Hit hit = tracer.bounce_hit(spawn_ray(at.point(), direction));
  if (hit.is_miss()) return transport.lights.escaped(direction);
  return transport.lights.emitted(surface_at(*transport.scene.geometry, hit), -direction);
}

Rgb sample_hemisphere(const LightTransport& transport, const Interaction& at, VertexSampler& sampler,
                      Tracer& tracer) {
  const std::uint32_t count = transport.lights.size() * transport.samples_per_light;
  Rgb sum;
  for (std::uint32_t part = 0; part < count; ++part) {
    const Vec2 u = sampler.draw_2d(Purpose::light_point, part, count, 0);
    const Vec3 direction = at.to_world(square_to_uniform_hemisphere(u));
    const Rgb scattered = at.scattered(direction);
    if (!is_black(scattered)) sum += scattered * lamp_radiance(transport, at, direction, tracer);
  }
  return count == 0 ? Rgb{} : sum / (float(count) * uniform_hemisphere_pdf());
}

}  // namespace

Rgb direct_light(const LightTransport& transport, const Interaction& at, VertexSampler& sampler,
                 Tracer& tracer) {
  return transport.method == DirectMethod::lights ? sample_lights(transport, at, sampler, tracer)
                                                  : sample_hemisphere(transport, at, sampler, tracer);
}

}  // namespace twinray
