// SPDX-License-Identifier: Apache-2.0
// What a wave does at surfaces that are not Lambert's: in lanes for the lobes that these know, else one by
// one, by the functions of the reference. The lanes of Lambert surfaces have worked there, too, as if the
// surfaces were black; what they wrote is overwritten.
#include <algorithm>

#include "core/spawn_ray.h"
#include "integrators/emergence.h"
#include "integrators/scattering.h"
#include "integrators/wave/path_wave.h"

namespace twinray {

template <typename F>
void PathWave::for_each_lobe(F&& f) {
  f(wave_.lambert, stages_.lambert);
  f(wave_.coated_diffuse, stages_.coated_diffuse);
  f(wave_.rough_conductor, stages_.rough_conductor);
  f(wave_.principled, stages_.principled);
}

bool PathWave::is_listed(OtherSurface& other) {
  if (context_.has_bodies && goes_below(context_.transport.scene, other.at)) {
    other.at.keep_above();
    return false;
  }
  const Bsdf& bsdf = other.at.bsdf();
  const auto list = [&](auto& surfaces, const auto& lobe) {
    surfaces.add(other.index, other.at, lobe);
    return true;
  };
  if (const auto* const lambert = bsdf.as<LambertLobe>()) return list(wave_.lambert, *lambert);
  if (const auto* const metal = bsdf.as<RoughConductorLobe>()) return list(wave_.rough_conductor, *metal);
  if (const auto* const lobe = bsdf.as<CoatedDiffuseLobe>())
    return (lobe->coat().is_smooth() || lobe->coat().facets().has_one_alpha()) &&
           list(wave_.coated_diffuse, *lobe);
  const auto* const principled = bsdf.as<PrincipledLobe>();
  const auto bare = principled ? principled->bare() : std::nullopt;
  return bare && list(wave_.principled, *bare);
}

void PathWave::find_others() {
  wave_.others.clear();
  wave_.alone.clear();
  for_each_lobe([](auto& lobes, const auto& /*stages*/) { lobes.clear(); });
  for (std::size_t i = 0; i < paths_.size; ++i) {
    const Hit& hit = wave_.hits[i];
    if (context_.shapes[hit.mesh].is_lambert) continue;
    const Viewing viewing{Materials(paths_.materials[i]), paths_.interiors_at(i)};
    const Vec3 wo = -normalize(paths_.direction.at(i));
    if (is_in_medium(i))
      wave_.others.emplace_back(
          i, Interaction::in_medium(context_.transport.scene, surfaces_.point.position.at(i), wo, viewing));
    else
      wave_.others.emplace_back(i, context_.bsdfs, found_surface(i), wo, viewing);
    if (is_listed(wave_.others.back())) continue;
    wave_.others.back().at.look_ahead();
    wave_.alone.push_back(std::uint32_t(wave_.others.size() - 1));
  }
}

SurfacePoint PathWave::found_surface(std::size_t i) const {
  const Hit& hit = wave_.hits[i];
  SurfacePoint point = point_at(i);
  point.shading_normal = surfaces_.shading.at(i);
  point.uv = point.second_uv = {hit.u, hit.v};
  if (has_textures()) {
    const TexturePoint at = texture_point_at(i);
    point.uv = at.uv;
    point.second_uv = at.second_uv;
    point.footprint = at.footprint;
    point.second_footprint = at.second_footprint;
    point.width = at.width;
    point.texture_draw = at.draw;
  }
  point.shape = hit.mesh;
  point.primitive = hit.primitive;
  point.instance = hit.instance;
  return point;
}

void PathWave::show_others() {
  std::fill_n(surfaces_.lets_through.values, paths_.size, 0u);
  for (const OtherSurface& other : wave_.others) {
    surfaces_.reflectance.set(other.index, other.at.albedo());
    show_receiver(other);
  }
}

void PathWave::show_receiver(const OtherSurface& other) {
  const Receiver receiver = other.at.receiver();
  surfaces_.shading.set(other.index, receiver.normal);
  surfaces_.lets_through[other.index] = receiver.lets_light_through ? 1 : 0;
}

void PathWave::scatter_light_at_lobes(const MisRequest& mis) {
  for_each_lobe([&](const auto& lobes, const auto& stages) {
    if (lobes.size == 0) return;
    stages.scatter_light(lobes, surfaces_, light_, mis, wave_.scattered_at_lobes);
    for (std::size_t k = 0; k < lobes.size; ++k)
      connections_.scattered.set(lobes.surface[k], wave_.scattered_at_lobes.at<Rgb>(k));
  });
}

void PathWave::scatter_light_at_others(std::uint32_t light) {
  for (const std::uint32_t n : wave_.alone) {
    const OtherSurface& other = wave_.others[n];
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
  // Of the sample's direction: that of the shadow ray, whose ends are moved off the surfaces, may point to
  // the other side where a light is very close.
  return other->at.interiors(light_.direction.at(surface));
}

void PathWave::keep_throughput_at_others() {
  for (OtherSurface& other : wave_.others) other.throughput = paths_.throughput.at<Rgb>(other.index);
  for_each_lobe([&](auto& lobes, const auto& /*stages*/) {
    for (std::size_t k = 0; k < lobes.size; ++k)
      lobes.throughput.set(k, paths_.throughput.at<Rgb>(lobes.surface[k]));
  });
}

void PathWave::scatter_at_lobes() {
  const LobePaths& found = wave_.lobe_paths;
  for_each_lobe([&](const auto& lobes, const auto& stages) {
    if (lobes.size == 0) return;
    stages.scatter_paths(lobes, surfaces_, {wave_.lobe, wave_.ux, wave_.uy}, wave_.lobe_paths);
    for (std::size_t k = 0; k < lobes.size; ++k) {
      const std::size_t i = lobes.surface[k];
      paths_.throughput.set(i, found.throughput.at<Rgb>(k));
      paths_.direction.set(i, found.direction.at(k));
      wave_.origin.set(i, found.origin.at(k));
      wave_.pdf[i] = found.pdf[k];
      wave_.seeking[i] = found.seeking[k];
      wave_.kind[i] = found.kind[k];
    }
  });
}

void PathWave::scatter_at_others() {
  wave_.walks.clear();
  if (wave_.others.empty()) return;
  draw(Purpose::lobe, {}, wave_.unused, wave_.lobe);
  scatter_at_lobes();
  for (const std::uint32_t n : wave_.alone) {
    const OtherSurface& other = wave_.others[n];
    const std::size_t i = other.index;
    const Vec2 u{wave_.ux[i], wave_.uy[i]};
    const auto next = twinray::scatter(other.at, other.throughput, wave_.lobe[i], u);
    paths_.throughput.set(i, Rgb{});
    if (!next) continue;
    if (next->is_below)
      go_below(n, *next);
    else
      go_on(other, *next);
  }
}

void PathWave::go_on(const OtherSurface& other, const Scattering& next) {
  const std::size_t i = other.index;
  paths_.throughput.set(i, next.throughput);
  paths_.direction.set(i, next.direction);
  if (context_.has_interiors) paths_.interiors.set(i, next.interiors.bits());
  paths_.eta_squared[i] *= next.eta * next.eta;
  wave_.kind[i] = std::uint32_t(next.kind);
  wave_.pdf[i] = next.departure.pdf;
  wave_.seeking[i] = std::uint32_t(next.departure.seeking);
  wave_.origin.set(i, leave_surface(other.at.point(), next.direction));
}

}  // namespace twinray
