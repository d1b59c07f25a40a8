// SPDX-License-Identifier: Apache-2.0
#include "integrators/path_reference.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/spawn_ray.h"
#include "core/subsurface.h"
#include "integrators/layer_records.h"
#include "integrators/scattering.h"
#include "integrators/walk_below.h"

namespace twinray {
namespace {

Rgb at_least(const Rgb& color, float least) {
  return {std::max(color.r, least), std::max(color.g, least), std::max(color.b, least)};
}

}  // namespace

PathReference::PathReference(const Scene& scene, const PathOptions& options)
    : scene_(scene),
      options_(options),
      lights_(scene, {compensation_for(options.direct, options.samples_per_light), options.many_lights}),
      bsdfs_(scene, options.regularize ? Materials::regularized : Materials::exact),
      passages_(scene),
      has_environment_(has_environment(scene)),
      has_flights_(has_flights(scene.materials)) {
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
  End end = fly(tracer, sampler, path, tracer.camera_hit(path.ray));
  const Hit& hit = end.hit;
  if (record.has(Layer::alpha))
    record[Layer::alpha][0] = alpha_record(end.is_beyond_scene(), has_environment_);
  for (int depth = 0;; ++depth) {  // Scattering events before the current ray.
    tracer.arrive();
    if (options_.counts(depth) && !end.in_medium) {
      const Arrival arrival{hit, normalize(path.ray.direction)};
      const Rgb light = depth == 0
                            ? seen_light(transport, arrival, observer, division.groups())
                            : found_light(transport, path.departure, arrival, observer, division.groups());
      const LightTerm found = term(path.throughput, light, depth, observer);
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
        const LightTerm direct = term(path.throughput, light, depth + 1, observer);
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
    end = fly(tracer, sampler, path, tracer.bounce_hit(path.ray));
  }
}

PathReference::End PathReference::fly(Tracer& tracer, const VertexSampler& sampler, State& path,
                                      const Hit& hit) const {
  Way way{path.ray, hit, path.viewing.interiors};
  if (has_flights_) way.flight.emplace(path.throughput, sampler.draw_1d(Purpose::medium));
  if (passages_.is_one(hit)) passages_.follow(tracer, way);
  const Rgb passed = std::exchange(way.left, {1, 1, 1});
  if (!way.is_scattered) way.goes_on(scene_, way.hit.t);
  const Rgb left = way.weight();
  path.ray = way.ray;
  path.viewing.interiors = way.interiors;
  path.throughput = path.throughput * passed * left;
  End end{way.hit, {}};
  if (way.is_scattered) {
    end = {Hit{}, way.scattered_at()};
    path.cone = path.cone.at(way.t_scattered() * length(way.ray.direction));
  }
  tracer.observer().arrived(
      {way.ray, end.hit, path.throughput, passed * left, way.flight && way.flight->has_begun()});
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

LightTerm PathReference::term(const Rgb& throughput, const Rgb& light, int depth,
                              PathObserver& observer) const {
  const LightTerm term{throughput, light, options_.clamp_factor(throughput * light, depth)};
  observer.added({throughput * light, term.radiance()});
  return term;
}

Interaction PathReference::arrive(const End& end, const VertexSampler& sampler, State& path) const {
  const Vec3 wo = -normalize(path.ray.direction);
  if (end.in_medium) return Interaction::in_medium(scene_, *end.in_medium, wo, path.viewing);
  Interaction at(bsdfs_, arrive_at(end.hit, sampler, path), wo, path.viewing);
  if (goes_below(at)) at.keep_above();
  return at;
}

bool PathReference::goes_below(const Interaction& at) const {
  const Material& material = scene_.materials[at.material()];
  if (!has_subsurface(material)) return false;
  if (max_component(material.subsurface.radius) < least_radius * at.point().offset) return false;
  if (at.side() == Side::outside) return true;
  // Nothing but a walk gets into a body that is opaque: mostly its surface is turned inside out.
  const ShapeBinding& binding = scene_.bindings[at.point().shape];
  return binding.material == at.material() && binding.alpha == no_texture && !lets_light_in(material);
}

std::optional<Interaction> PathReference::emerge(const Interaction& from, const WalkDraws& draws,
                                                 Tracer& tracer, State& path) const {
  const SurfacePoint& in = from.point();
  const std::uint32_t material = from.material(), body = scene_.bindings[in.shape].material;
  Subsurface below = scene_.materials[material].subsurface;
  below.radius = at_least(below.radius, least_radius * in.offset);
  // The way to the ray's origin, as steep as it mostly is.
  const float cosine = std::fabs(dot(in.geometric_normal, path.ray.direction));
  const Rgb reflectance = from.reflectance_below();
  WalkStart start{path.ray, in.offset / std::max(cosine, 0.25f), path.viewing.interiors};
  if (from.side() == Side::inside) start.left_if_open = reflectance;
  const auto end =
      walk_below(scene_, tracer, medium_below(below, reflectance), body, start, path.throughput, draws);
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
  const bool is_back = end->hit.is_miss();
  const auto emerged =
      Interaction::emerging(bsdfs_, is_back ? in : arrive_at(end->hit, draws.at_end(), path), material,
                            is_back ? from.wo() : normalize(path.ray.direction), path.viewing);
  tracer.observer().stands_at(emerged, path.viewing.materials);
  return emerged;
}

SurfacePoint PathReference::arrive_at(const Hit& hit, const VertexSampler& sampler, State& path) const {
  SurfacePoint point = surface_at(*scene_.geometry, hit);
  if (scene_.textures.empty()) return point;
  const Vec3& direction = path.ray.direction;
  path.cone = path.cone.at(hit.t * length(direction));
  const auto footprint = [&](CoordinateSet set) {
    return texture_footprint(*scene_.geometry, hit, point, path.cone.width, direction, set);
  };
  point.footprint = footprint(CoordinateSet::first);
  point.second_footprint = footprint(CoordinateSet::second);
  point.width = section_width(point, path.cone.width, direction);
  point.texture_draw = sampler.draw_2d(Purpose::texture);
  return point;
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
