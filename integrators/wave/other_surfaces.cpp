// SPDX-License-Identifier: Apache-2.0
// What a wave does at surfaces that are not Lambert's: one by one, by the functions of the reference. The
// lanes have worked there, too, as if the surfaces were black; what they wrote is overwritten.
#include <algorithm>

#include "core/spawn_ray.h"
#include "integrators/scattering.h"
#include "integrators/wave/path_wave.h"

namespace twinray {

void PathWave::find_others() {
  wave_.others.clear();
  for (std::size_t i = 0; i < paths_.size; ++i) {
    const Hit& hit = wave_.hits[i];
    if (context_.shapes[hit.mesh].is_lambert) continue;
    const Viewing viewing{Materials(paths_.materials[i]), paths_.interiors_at(i)};
    wave_.others.emplace_back(i, context_.bsdfs, with_footprint(found_surface(i), i),
                              -normalize(paths_.direction.at(i)), viewing);
  }
}

SurfacePoint PathWave::found_surface(std::size_t i) const {
  const Hit& hit = wave_.hits[i];
  SurfacePoint point;
  point.position = surfaces_.point.position.at(i);
  point.geometric_normal = surfaces_.point.normal.at(i);
  point.shading_normal = surfaces_.shading.at(i);
  point.uv = {hit.u, hit.v};
  point.offset = surfaces_.point.offset[i];
  point.shape = hit.mesh;
  point.primitive = hit.primitive;
  point.instance = hit.instance;
  return point;
}

void PathWave::show_others() {
  for (const OtherSurface& other : wave_.others) {
    surfaces_.reflectance.set(other.index, other.at.bsdf().albedo());
    surfaces_.shading.set(other.index, other.at.normal());
  }
}

void PathWave::scatter_light_at_others(std::uint32_t light) {
  for (const OtherSurface& other : wave_.others) {
    const std::size_t i = other.index;
    const LightSample sample{light_.direction.at(i), light_.radiance.at<Rgb>(i), light_.pdf[i],
                             light_.ray(i)};
    connections_.scattered.set(i, scattered_sample(context_.transport, light, other.at, sample));
  }
}

void PathWave::look_around_others() {
  for (const OtherSurface& other : wave_.others) {
    const std::size_t i = other.index;
    const Look look = look_around(other.at, {light_.ux[i], light_.uy[i]});
    const Ray ray = spawn_ray(other.at.point(), look.direction);
    light_.direction.set(i, look.direction);
    light_.pdf[i] = look.density;
    light_.origin.set(i, ray.origin);
    light_.towards.set(i, ray.direction);
    connections_.scattered.set(i, other.at.scattered(look.direction).value);
  }
}

Interiors PathWave::interiors_of(std::size_t connection) const {
  const std::uint32_t surface = connections_.surface[connection];
  const auto other =
      std::lower_bound(wave_.others.begin(), wave_.others.end(), surface,
                       [](const OtherSurface& a, std::uint32_t index) { return a.index < index; });
  if (other == wave_.others.end() || other->index != surface) return paths_.interiors_at(surface);
  return other->at.interiors(connections_.rays[connection].direction);
}

void PathWave::keep_throughput_at_others() {
  for (OtherSurface& other : wave_.others) other.throughput = paths_.throughput.at<Rgb>(other.index);
}

void PathWave::scatter_at_others() {
  if (!wave_.others.empty()) draw(Purpose::lobe, {}, wave_.unused, wave_.lobe);
  for (const OtherSurface& other : wave_.others) {
    const std::size_t i = other.index;
    const Vec2 u{wave_.ux[i], wave_.uy[i]};
    const auto next = twinray::scatter(other.at, other.throughput, wave_.lobe[i], u);
    paths_.throughput.set(i, next ? next->throughput : Rgb{});
    if (!next) continue;
    paths_.direction.set(i, next->direction);
    if (context_.has_interiors) paths_.interiors.set(i, next->interiors.bits());
    paths_.eta_squared[i] *= next->eta * next->eta;
    wave_.kind[i] = std::uint32_t(next->kind);
    wave_.pdf[i] = next->departure.pdf;
    wave_.seeking[i] = std::uint32_t(next->departure.seeking);
    wave_.origin.set(i, leave_surface(other.at.point(), next->direction));
  }
}

}  // namespace twinray
