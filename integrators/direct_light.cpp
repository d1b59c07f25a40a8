// SPDX-License-Identifier: Apache-2.0
#include "integrators/direct_light.h"

#include "core/spawn_ray.h"
#include "core/warp.h"

namespace twinray {
namespace {

/// Shadow rays are traced once so many wait; the last estimate may add more. So many samples of many lights
/// need no memory for all paths of a wave.
constexpr std::size_t most_waiting = 4096;

/// Radiance that arrives from a direction straight from an emitter.
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

DirectLight::DirectLight(const LightTransport& transport) : transport_(transport) {
  for (std::uint32_t light = 0; light < transport.lights.size(); ++light)
    parts_.push_back(transport.lights.is_delta(light) ? 1 : transport.samples_per_light);
}

void DirectLight::draw(const Interaction& at, const Rgb& throughput, VertexSampler& sampler, Tracer& tracer,
                       Rgb& radiance) {
  Rgb known;
  if (transport_.method == DirectMethod::lights)
    draw_lights(at, sampler);
  else
    known = sample_hemisphere(transport_, at, sampler, tracer);
  estimates_.push_back({&radiance, throughput, known, terms_.size()});
  if (terms_.size() >= most_waiting) finish(tracer);
}

void DirectLight::draw_lights(const Interaction& at, VertexSampler& sampler) {
  for (std::uint32_t light = 0; light < transport_.lights.size(); ++light)
    for (std::uint32_t part = 0; part < parts_[light]; ++part) {
      const Vec2 u = sampler.draw_2d(Purpose::light_point, part, parts_[light], light);
      const LightSample sample = transport_.lights.sample(light, at.point(), u);
      const Rgb scattered = at.scattered(sample.direction) * sample.radiance;
      if (is_black(scattered)) continue;
      terms_.push_back({scattered, sample.pdf, light});
      shadow_rays_.push_back(sample.shadow_ray);
    }
}

void DirectLight::finish(Tracer& tracer) {
  const std::span<const Rgb> visible = tracer.visibilities(shadow_rays_);
  std::size_t begin = 0;
  for (const Estimate& estimate : estimates_) {
    *estimate.radiance += estimate.throughput * (estimate.known + sum(begin, estimate.terms, visible));
    begin = estimate.terms;
  }
  estimates_.clear();
  terms_.clear();
  shadow_rays_.clear();
}

/// The lights' means, added up light by light.
Rgb DirectLight::sum(std::size_t begin, std::size_t end, std::span<const Rgb> visible) const {
  Rgb sum;
  for (std::size_t i = begin; i < end;) {
    const std::uint32_t light = terms_[i].light;
    Rgb of_light;
    for (; i < end && terms_[i].light == light; ++i)
      of_light += terms_[i].scattered * visible[i] / terms_[i].pdf;
    sum += of_light / float(parts_[light]);
  }
  return sum;
}

}  // namespace twinray
