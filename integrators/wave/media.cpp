// SPDX-License-Identifier: Apache-2.0
// What a wave does between surfaces: media that dim light or scatter paths, and surfaces that are not there.
#include <limits>

#include "integrators/wave/follow_together.h"
#include "integrators/wave/path_wave.h"

namespace twinray {

void PathWave::take_off(std::uint32_t vertex) {
  const Scene& scene = context_.transport.scene;
  // Both are in one pair of draws.
  if (context_.has_flights || context_.has_uneven_glow)
    draw_at(vertex, Purpose::medium, {}, wave_.flight, wave_.glow);
  if (!context_.has_flights) return;
  wave_.flights.assign(paths_.size, std::nullopt);
  for (std::size_t i = 0; i < paths_.size; ++i) {
    const Interior* const medium = medium_in(scene.materials, paths_.interiors_at(i));
    if (!medium || !scatters(*medium)) continue;
    wave_.flights[i].emplace(paths_.throughput.at<Rgb>(i), wave_.flight[i]);
    wave_.rays[i] = way_of(i, {}).needed_ray(scene);
  }
}

Way PathWave::way_of(std::size_t i, const Hit& hit) const {
  Way way{wave_.rays[i], hit, paths_.interiors_at(i)};
  if (context_.has_flights) way.flight = wave_.flights[i];
  if (context_.transport.has_glow) way.glow_draw = wave_.glow[i];
  return way;
}

void PathWave::fly(int depth) {
  if (!context_.has_interiors && context_.passages.empty()) return;
  wave_.passing.clear();
  for (std::size_t i = 0; i < paths_.size; ++i) {
    const Hit& hit = wave_.hits[i];
    const bool passes = context_.passages.is_one(wave_.rays[i], hit);
    if (paths_.interiors_at(i).empty() && !passes) continue;
    Way way = way_of(i, hit);
    way.ray.t_max = std::numeric_limits<float>::infinity();
    if (!passes) {
      land(i, way, depth);
      continue;
    }
    // It may come into a medium that scatters.
    if (context_.has_flights && !way.flight)
      way.flight.emplace(paths_.throughput.at<Rgb>(i), wave_.flight[i]);
    wave_.passing.emplace_back(std::uint32_t(i), context_.passages, way);
  }
  follow_passing(RayKind::bounce);
  for (PassingPath& path : wave_.passing) land(path.index, path.ray.way(), depth);
}

void PathWave::land(std::size_t i, Way way, int depth) {
  way.ends(context_.transport.scene);
  if (!is_black(way.glow)) add_glow(i, paths_.throughput.at<Rgb>(i) * way.glow, depth);
  paths_.throughput.set(i, paths_.throughput.at<Rgb>(i) * way.weight());
  paths_.interiors.set(i, way.interiors.bits());
  wave_.rays[i] = way.ray;
  wave_.hits[i] = way.is_scattered ? Hit{.t = way.t_scattered(), .mesh = context_.medium()} : way.hit;
}

void PathWave::connect_through_passages() {
  const std::size_t size = connections_.size;
  const std::span<Hit> hits = std::span(connections_.hits).first(size);
  tracer_.hits(std::span(connections_.rays).first(size), RayKind::shadow, hits);
  wave_.passing.clear();
  for (std::size_t k = 0; k < size; ++k) {
    const Way way{connections_.rays[k], hits[k], interiors_of(k)};
    if (context_.passages.is_one(way.ray, way.hit))
      wave_.passing.emplace_back(connections_.surface[k], context_.passages, way);
    else
      connections_.arriving.set(connections_.surface[k], visibility(context_.transport.scene, way));
  }
  follow_passing(RayKind::shadow);
  for (const PassingPath& path : wave_.passing)
    connections_.arriving.set(path.index, visibility(context_.transport.scene, path.ray.way()));
}

void PathWave::follow_passing(RayKind kind) {
  wave_.going.clear();
  for (std::size_t n = 0; n < wave_.passing.size(); ++n) {
    PassingRay& ray = wave_.passing[n].ray;
    if (ray.goes_on(ray.way().hit)) wave_.going.push_back(std::uint32_t(n));
  }
  const auto ray_of = [&](std::uint32_t n) -> PassingRay& { return wave_.passing[n].ray; };
  follow_together(tracer_, kind, ray_of, wave_.going, {wave_.followed_rays, wave_.followed_hits});
}

void PathWave::absorb_light() {
  for (std::size_t i = 0; i < paths_.size; ++i)
    if (const Interiors interiors = paths_.interiors_at(i); !interiors.empty())
      connections_.scattered.set(
          i, connections_.scattered.at<Rgb>(i) *
                 transmittance(context_.transport.scene, interiors, light_.ray(i), light_.t_max[i]));
}

}  // namespace twinray
