// SPDX-License-Identifier: Apache-2.0
#include "integrators/path_reference.h"

#include "core/spawn_ray.h"
#include "integrators/emergence.h"
#include "integrators/layer_records.h"
#include "integrators/scattering.h"
#include "integrators/seen_point.h"

namespace twinray {

PathReference::PathReference(const Scene& scene, const PathOptions& options)
    : scene_(scene),
      options_(options),
      lights_(scene, {compensation_for(options.direct, options.samples_per_light), options.many_lights}),
      bsdfs_(scene, options.regularize ? Materials::regularized : Materials::exact),
      passages_(scene),
      has_environment_(has_environment(scene)),
      has_flights_(has_flights(scene.materials)),
      has_glow_(has_glow(scene.materials)) {
  check(options);
}

void PathReference::sample(std::span<const CameraSample> samples, SamplerKind kind, Tracer& tracer,
                           const RecordSpans& records) const {
  records.clear();
  for (std::size_t i = 0; i < samples.size(); ++i)
    records.color()[i] = radiance_of(samples[i], kind, tracer, records.part(i, 1));
}

Rgb PathReference::radiance_of(const CameraSample& sample, SamplerKind kind, Tracer& tracer,
                               const RecordSpans& record) const {
  const LightTransport transport = this->transport();
  const PathKey path_key(sample.key);
  PathObserver& observer = tracer.observer();
  LightDivision division(scene_, record);
  Rgb radiance;
  State path{.ray = sample.ray, .cone = sample.cone};
  path.viewing.interiors = sample.interiors;
  VertexSampler sampler(kind, path_key, 0);
  End end = fly(tracer, sampler, path, RayKind::camera);
  const Hit& hit = end.hit;
  if (record.has(Layer::alpha))
    record[Layer::alpha][0] = alpha_record(end.is_beyond_scene(), has_environment_);
  for (int depth = 0;; ++depth) {  // Scattering events before the current ray.
    tracer.arrive();
    if (options_.counts(depth) && !is_black(end.glow)) {
      const LightTerm glow = term({1, 1, 1}, end.glow, depth);
      observer.passed_glow(glow.seen());
      division.groups().add_glow(end.glow);
      radiance += glow.radiance();
      division.add_found(false, path.first, glow, depth);
    }
    if (options_.counts(depth) && !end.in_medium) {
      const Arrival arrival{hit, normalize(path.ray.direction)};
      const Rgb light = depth == 0
                            ? seen_light(transport, arrival, observer, division.groups())
                            : found_light(transport, path.departure, arrival, observer, division.groups());
      const LightTerm found = term(path.throughput, light, depth);
      observer.added(found.seen());
      radiance += found.radiance();
      division.add_found(hit.is_miss(), path.first, found, depth);
    }
    if (end.is_beyond_scene()) return radiance;

    sampler = VertexSampler(kind, path_key, std::uint32_t(depth) + 1);
    const Interaction at = arrive(end, sampler, path);
    observer.stands_at(at, path.viewing.materials);
    const bool has_ended = options_.ends(depth, path.bounces);
    if (depth == 0 || !has_ended) record_vertex(at, hit, depth, path, record);
    if (has_ended) return radiance;
    const auto leave = [&](const Interaction& from, const VertexSampler& draws) {
      if (options_.counts(depth + 1)) {
        const Rgb light = direct_light(transport, from, draws, tracer, division.shares(from, depth));
        const LightTerm direct = term(path.throughput, light, depth + 1);
        observer.added(direct.seen());
        radiance += direct.radiance();
        division.add_direct(from, path.first, direct, depth);
      }
      if (!scatter(from, depth, draws, path, observer)) return false;
      if (depth == 0 && record.has(Division::paths))
        path.first = first_scattering(from, path.ray.direction, path.departure.seeking);
      return true;
    };
    if (!leave(at, sampler)) return radiance;
    if (path.is_below) {
      const WalkDraws draws(kind, path_key, std::uint32_t(depth) + 1);
      const std::optional<Interaction> emerged = emerge(at, draws, tracer, path);
      if (!emerged || !leave(*emerged, draws.at_end())) return radiance;
    }
    // The ray after the last surface only looks for light.
    const bool is_last = options_.ends(depth + 1, path.bounces);
    if (is_last && !may_find_light(transport, path.departure)) return radiance;
    end = fly(tracer, sampler, path, RayKind::bounce);
  }
}

PathReference::End PathReference::fly(Tracer& tracer, const VertexSampler& sampler, State& path,
                                      RayKind kind) const {
  Way begun{path.ray, {}, path.viewing.interiors};
  if (has_glow_) begun.glow_draw = sampler.draw_1d(Purpose::glow);
  if (has_flights_) begun.flight.emplace(path.throughput, sampler.draw_1d(Purpose::medium));
  PassingRay passing(passages_, begun);
  const Ray first = passing.ray();
  for (Hit hit = kind == RayKind::camera ? tracer.camera_hit(first) : tracer.bounce_hit(first);
       passing.goes_on(hit);)
    hit = tracer.bounce_hit(passing.ray());
  Way way = passing.way();
  way.ends(scene_);
  const Rgb left = way.weight();
  path.ray = way.ray;
  path.viewing.interiors = way.interiors;
  End end{way.hit, {}, path.throughput * way.glow};
  path.throughput = path.throughput * left;
  if (way.is_scattered) {
    end.hit = {};
    end.in_medium = way.scattered_at();
    path.cone = path.cone.at(way.t_scattered() * length(way.ray.direction));
  }
  tracer.observer().arrived({way.ray, end.hit, path.throughput, left, way.flight && way.flight->has_begun()});
  return end;
}

void PathReference::record_vertex(const Interaction& at, const Hit& hit, int depth, const State& path,
                                  const RecordSpans& record) const {
  if (path.is_followed && record.has(Layer::albedo))
    record[Layer::albedo][0] = albedo_record({path.throughput, path.eta_squared, at.albedo()});
  if (path.is_followed && record.has(Layer::normal)) record[Layer::normal][0] = vector_record(at.normal());
  if (depth > 0 || at.is_in_medium()) return;
  const FirstSurface first{hit, at.point().position, facing(at.point().geometric_normal, at.wo())};
  record_first_surface(scene_, [&](Layer layer, auto&& value) {
    if (record.has(layer)) record[layer][0] = value(first);
  });
}

Rgb PathReference::seen_light(const LightTransport& transport, const Arrival& arrival, PathObserver& observer,
                              const LightGroups& groups) const {
  const Hit& hit = arrival.hit;
  const Vec3& direction = arrival.direction;
  const Rgb radiance = hit.is_miss() ? lights_.background(direction)
                                     : lights_.emitted(surface_at(*scene_.geometry, hit), -direction);
  observer.found_light({.light = light_at(scene_, hit), .radiance = radiance});
  add_seen_groups(transport, arrival, groups);
  return radiance;
}

LightTerm PathReference::term(const Rgb& throughput, const Rgb& light, int depth) const {
  return {throughput, light, options_.clamp_factor(throughput * light, depth)};
}

Interaction PathReference::arrive(const End& end, const VertexSampler& sampler, State& path) const {
  const Vec3 wo = -normalize(path.ray.direction);
  if (end.in_medium) return Interaction::in_medium(scene_, *end.in_medium, wo, path.viewing);
  const SurfacePoint point = seen_point(scene_, end.hit, path.ray.direction, sampler, path.cone);
  Interaction at(bsdfs_, point, wo, path.viewing);
  if (goes_below(scene_, at)) at.keep_above();
  at.look_ahead();
  return at;
}

std::optional<Interaction> PathReference::emerge(const Interaction& from, const WalkDraws& draws,
                                                 Tracer& tracer, State& path) const {
  const auto end =
      walk_below(tracer, walk_from(scene_, from, path.ray, path.viewing.interiors, path.throughput, draws));
  if (!end) return std::nullopt;
  path.ray = end->ray;
  path.throughput = path.throughput * end->left;
  path.viewing.interiors = end->interiors;
  path.eta_squared *= end->eta_squared;
  tracer.observer().arrived({.ray = end->ray,
                             .hit = end->hit,
                             .throughput = path.throughput,
                             .transmittance = end->left,
                             .is_flight = true,
                             .events_below = end->events});
  const Interaction emerged = come_out(bsdfs_, from, *end, draws.at_end(), path.viewing.materials, path.cone);
  tracer.observer().stands_at(emerged, path.viewing.materials);
  return emerged;
}

bool PathReference::scatter(const Interaction& at, int depth, const VertexSampler& sampler, State& path,
                            PathObserver& observer) const {
  const Vec2 u = sampler.draw_2d(Purpose::direction);
  const float lobe = at.is_lambert() ? 0 : sampler.draw_1d(Purpose::lobe);
  const auto next = twinray::scatter(at, path.throughput, lobe, u);
  observer.scattered(lobe, u, next ? &*next : nullptr);
  if (!next) return false;
  path.throughput = next->throughput;
  path.is_below = next->is_below;
  path.ray = spawn_ray(at.point(), next->direction);
  if (path.is_below) return true;  // Coming out is scattering of the same vertex: all else is its.
  path.bounces += one_bounce(next->kind);
  path.eta_squared *= next->eta * next->eta;
  path.departure = next->departure;
  path.is_followed = path.is_followed && next->departure.seeking == Seeking::alone;
  path.viewing.interiors = next->interiors;
  if (next->departure.seeking != Seeking::alone) path.cone = path.cone.scattered(next->departure.pdf);
  if (options_.regularize && next->departure.seeking != Seeking::alone)
    path.viewing.materials = Materials::regularized;
  return survives_roulette(depth + 1, sampler, path, observer);
}

bool PathReference::survives_roulette(int bounce, const VertexSampler& sampler, State& path,
                                      PathObserver& observer) const {
  if (!options_.roulette.applies(bounce)) return true;
  const float probability = options_.roulette.probability(path.throughput * path.eta_squared);
  if (probability >= 1) return true;
  const RouletteGame game{probability, sampler.draw_1d(Purpose::roulette), path.throughput / probability};
  observer.played_roulette(game);
  path.throughput = game.throughput;
  return game.is_survived();
}

}  // namespace twinray
