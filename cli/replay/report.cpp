// SPDX-License-Identifier: Apache-2.0
#include "cli/replay/report.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/replay/text.h"
#include "cli/version.h"
#include "io/exchange/writer.h"

namespace twinray {
namespace {

/// Objects keep their order; a number is a float, and has its digits.
using FloatJson = nlohmann::basic_json<nlohmann::ordered_map, std::vector, std::string, bool, std::int64_t,
                                       std::uint64_t, float>;

FloatJson json_of(float x) {
  return std::isfinite(x) ? FloatJson(x) : FloatJson(fmt::format("{}", std::isnan(x) ? std::fabs(x) : x));
}
FloatJson json_of(const Vec3& v) { return {json_of(v.x), json_of(v.y), json_of(v.z)}; }
FloatJson json_of(const Rgb& c) { return {json_of(c.r), json_of(c.g), json_of(c.b)}; }

FloatJson json_of(const Ray& ray) {
  return {{"origin", json_of(ray.origin)},
          {"direction", json_of(ray.direction)},
          {"t_min", json_of(ray.t_min)},
          {"t_max", json_of(ray.t_max)}};
}

FloatJson light_json(const Scene& scene, std::uint32_t light) {
  if (light == no_light) return nullptr;
  return {
      {"index", light}, {"name", scene.lights[light].name}, {"type", type_of(scene.lights[light].source)}};
}

FloatJson json_of(const std::optional<PathTerm>& term) {
  if (!term) return nullptr;
  return {{"light", json_of(term->light)}, {"term", json_of(term->term)}};
}

FloatJson json_of(const Scene& scene, const FoundLight& found) {
  return {{"light", light_json(scene, found.light)},
          {"radiance", json_of(found.radiance)},
          {"light_pdf", json_of(found.pdf)},
          {"weight", json_of(found.weight)}};
}

FloatJson json_of(const Scene& scene, const LoggedLightSample& logged) {
  const TakenLightSample& taken = logged.taken;
  const bool is_group = taken.source >= scene.lights.size();
  return {{"light", light_json(scene, is_group ? taken.sample.light : taken.source)},
          {"is_one_of_many", is_group},
          {"direction", json_of(taken.sample.direction)},
          {"radiance", json_of(taken.sample.radiance)},
          {"light_pdf", json_of(taken.sample.pdf)},
          {"bsdf_pdf", json_of(logged.bsdf_pdf)},
          {"weight", json_of(logged.weight)},
          {"scattered", json_of(taken.scattered)},
          {"is_traced", !is_black(taken.scattered)},
          {"visibility", json_of(taken.visibility)}};
}

FloatJson json_of(const Scene& scene, const TakenDirection& taken) {
  return {{"direction", json_of(taken.direction)},
          {"pdf", json_of(taken.pdf)},
          {"light", light_json(scene, taken.light)},
          {"radiance", json_of(taken.radiance)},
          {"scattered", json_of(taken.scattered)}};
}

FloatJson surface_json(const Scene& scene, const PathVertex& vertex) {
  const Interaction& at = *vertex.surface;
  const SurfacePoint& point = at.point();
  const Material& material = scene.materials[at.material()];
  const Hit& hit = vertex.arrival.hit;
  FloatJson result{
      {"shape", hit.mesh},
      {"shape_name", std::visit([](const auto& s) { return s.name; }, scene.geometry->shapes()[hit.mesh])},
      {"primitive", hit.primitive},
      {"point", json_of(point.position)},
      {"geometric_normal", json_of(point.geometric_normal)},
      {"shading_normal", json_of(at.normal())},
      {"uv", {point.uv.x, point.uv.y}},
      {"material", material.name},
      {"model", type_of(material.model)},
      {"albedo", json_of(at.albedo())},
      {"is_regularized", vertex.materials == Materials::regularized}};
  if (hit.instance != no_instance) result["instance"] = hit.instance;
  return result;
}

FloatJson medium_json(const Scene& scene, const Interaction& at) {
  const Material& material = scene.materials[at.material()];
  return {{"point", json_of(at.point().position)},
          {"within", material.name},
          {"scattering", json_of(material.interior.scattering)},
          {"absorption", json_of(material.interior.absorption)},
          {"anisotropy", json_of(material.interior.anisotropy)}};
}

FloatJson json_of(const Interaction& at, const LoggedScattering& scattering) {
  if (!scattering.next) return {{"goes_on", false}};
  return {{"goes_on", true},
          {"event", event_name(at, *scattering.next)},
          {"direction", json_of(scattering.next->direction)},
          {"is_delta", scattering.sample.is_delta},
          {"pdf", json_of(scattering.sample.pdf)},
          {"f", json_of(scattering.sample.value)},
          {"cosine", json_of(at.cosine(scattering.sample))},
          {"eta", json_of(scattering.sample.eta)},
          {"throughput", json_of(scattering.next->throughput)}};
}

FloatJson json_of(const RouletteGame& game) {
  return {{"probability", json_of(game.probability)},
          {"draw", json_of(game.draw)},
          {"is_survived", game.is_survived()},
          {"throughput", json_of(game.throughput)}};
}

FloatJson json_of(const Scene& scene, const PathVertex& vertex);

template <typename List>
FloatJson list_json(const Scene& scene, const List& list) {
  FloatJson all = FloatJson::array();
  for (const auto& entry : list) all.push_back(json_of(scene, entry));
  return all;
}

FloatJson json_of(const Scene& scene, const PathVertex& vertex) {
  FloatJson result{{"ray", json_of(vertex.arrival.ray)},
                   {"is_miss", !vertex.surface.has_value()},
                   {"is_flight", vertex.arrival.is_flight},
                   {"transmittance", json_of(vertex.arrival.transmittance)},
                   {"throughput", json_of(vertex.arrival.throughput)},
                   {"glow", json_of(vertex.glow)},
                   {"found_lights", list_json(scene, vertex.found)},
                   {"emission", json_of(vertex.emission)}};
  if (vertex.arrival.events_below) result["events_below"] = *vertex.arrival.events_below;
  if (!vertex.surface) return result;
  if (vertex.surface->is_in_medium()) {
    result["medium"] = medium_json(scene, *vertex.surface);
  } else {
    result["t"] = vertex.arrival.hit.t;
    result["surface"] = surface_json(scene, vertex);
  }
  result["light_samples"] = list_json(scene, vertex.light_samples);
  result["directions"] = list_json(scene, vertex.directions);
  result["direct_light"] = json_of(vertex.direct_light);
  if (vertex.scattering) result["scattering"] = json_of(*vertex.surface, *vertex.scattering);
  if (vertex.roulette) result["roulette"] = json_of(*vertex.roulette);
  return result;
}

}  // namespace

std::string replay_json(const ReplayedSample& replayed) {
  const RenderOptions& render = replayed.arguments.render;
  const PathLog& path = replayed.replay.path;
  FloatJson result{{"program", version_name()},
                   {"scene", replayed.arguments.scene},
                   {"resolution", {render.width, render.height}},
                   {"samples_per_pixel", render.samples},
                   {"seed", render.seed},
                   {"sampler", sampler_name(render.sampler)},
                   {"filter", filter_text(render.filter)},
                   {"weight", json_of(replayed.replay.sample.weight)},
                   {"lens", json_of(replayed.replay.sample.light)},
                   {"pixel", {replayed.place().x, replayed.place().y}},
                   {"sample", replayed.place().index},
                   {"vertices", list_json(replayed.scene, path.vertices())},
                   {"end", end_text(path.end())},
                   {"sum", json_of(path.sum())},
                   {"rendered", json_of(replayed.replay.radiance)}};
  if (replayed.time) result["time"] = *replayed.time;
  return result.dump(2, ' ', false, FloatJson::error_handler_t::replace) + "\n";
}

}  // namespace twinray
