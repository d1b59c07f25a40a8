// SPDX-License-Identifier: Apache-2.0
// What a wave does where paths go below surfaces: they walk together, ray by ray, until each comes out or is
// absorbed. Where it comes out is scattering of the same vertex: a path that does stands at another surface,
// whose light is worked out alone, by the functions of the reference.
#include <numeric>

#include "core/spawn_ray.h"
#include "integrators/emergence.h"
#include "integrators/light_division.h"
#include "integrators/scattering.h"
#include "integrators/wave/follow_together.h"
#include "integrators/wave/path_wave.h"

namespace twinray {

void PathWave::go_below(std::uint32_t n, const Scattering& next) {
  const OtherSurface& other = wave_.others[n];
  const std::size_t i = other.index;
  PathKey key;
  key.pixel = paths_.pixel.at(i);
  key.index = paths_.index[i];
  const WalkDraws draws(kind_, key, std::uint32_t(depth_) + 1);
  const Ray into = spawn_ray(other.at.point(), next.direction);
  wave_.walks.push_back(
      {n, draws, next.throughput,
       walk_from(context_.transport.scene, other.at, into, paths_.interiors_at(i), next.throughput, draws)});
}

void PathWave::walk() {
  wave_.going.resize(wave_.walks.size());
  std::iota(wave_.going.begin(), wave_.going.end(), 0u);
  const auto walk_of = [&](std::uint32_t n) -> WalkBelow& { return wave_.walks[n].walk; };
  follow_together(tracer_, RayKind::bounce, walk_of, wave_.going, {wave_.followed_rays, wave_.followed_hits});
  for (const BodyWalk& walk : wave_.walks)
    if (walk.walk.end()) come_out(walk);
}

void PathWave::come_out(const BodyWalk& walk) {
  const LightTransport& transport = context_.transport;
  const WalkEnd& end = *walk.walk.end();
  const VertexSampler draws = walk.draws.at_end();
  OtherSurface& other = wave_.others[walk.other];
  const std::size_t i = other.index;
  RayCone cone{paths_.cone_width[i], paths_.cone_spread[i]};
  other.at = twinray::come_out(context_.bsdfs, other.at, end, draws, Materials(paths_.materials[i]), cone);
  other.throughput = walk.throughput * end.left;
  paths_.cone_width[i] = cone.width;
  paths_.eta_squared[i] *= end.eta_squared;
  surfaces_.point.position.set(i, other.at.point().position);
  show_receiver(other);
  if (context_.options.counts(depth_ + 1)) {
    const std::uint32_t sample = paths_.sample[i];
    const RecordSpans record = records_.part(sample, 1);
    LightDivision division(transport.scene, record);
    const Rgb light = direct_light(transport, other.at, draws, tracer_, division.shares(other.at, depth_));
    const LightTerm term{other.throughput, light,
                         context_.options.clamp_factor(other.throughput * light, depth_ + 1)};
    radiance_[sample] += term.radiance();
    division.add_direct(other.at, first_scattering_of(sample), term, depth_);
  }
  const Vec2 u = draws.draw_2d(Purpose::direction);
  const auto next = twinray::scatter(other.at, other.throughput, draws.draw_1d(Purpose::lobe), u);
  if (next) go_on(other, *next);
}

void PathWave::draw_roulette_of_walks() {
  for (const BodyWalk& walk : wave_.walks)
    if (walk.walk.end())
      wave_.ux[wave_.others[walk.other].index] = walk.draws.at_end().draw_1d(Purpose::roulette);
}

}  // namespace twinray
