// SPDX-License-Identifier: Apache-2.0
#include "cli/replay/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/exchange/writer.h"

namespace twinray {
namespace {

std::string text_of(const Vec3& v) { return fmt::format("{} {} {}", v.x, v.y, v.z); }
std::string text_of(const Rgb& c) { return fmt::format("{} {} {}", c.r, c.g, c.b); }

/// A line below a vertex: what it is, and its value.
std::string line(const char* name, const std::string& value) {
  return fmt::format("  {:<17}{}\n", name, value);
}

/// "coated_diffuse" -> "coated diffuse".
std::string words_of(std::string type) {
  std::replace(type.begin(), type.end(), '_', ' ');
  return type;
}

/// "lamp" (mesh)
std::string light_text(const Scene& scene, std::uint32_t light) {
  if (light == no_light) return "what is beyond the scene";
  return fmt::format("\"{}\" ({})", scene.lights[light].name, words_of(type_of(scene.lights[light].source)));
}

std::string shape_text(const Scene& scene, const Hit& hit) {
  const Shape& shape = scene.geometry->shapes()[hit.mesh];
  const std::string name = std::visit([](const auto& s) { return s.name; }, shape);
  const std::string text =
      fmt::format("shape {} \"{}\", {} {}", hit.mesh, name,
                  std::holds_alternative<Mesh>(shape) ? "triangle" : "sphere", hit.primitive);
  return hit.instance == no_instance ? text : fmt::format("{}, of instance {}", text, hit.instance);
}

std::string found_text(const Scene& scene, const FoundLight& found) {
  const std::string text =
      fmt::format("{}: radiance {}", light_text(scene, found.light), text_of(found.radiance));
  if (found.pdf == 0) return text + ", which no light sample brings";
  return text + fmt::format(", density of a light sample {}, MIS weight {}", found.pdf, found.weight);
}

std::string term_text(const PathTerm& term) {
  if (term.light.r == term.term.r && term.light.g == term.term.g && term.light.b == term.term.b)
    return text_of(term.term);
  return fmt::format("{}, clamped to {}", text_of(term.light), text_of(term.term));
}

/// What a ray has found, and what that adds.
std::string emission_text(const Scene& scene, const PathVertex& vertex) {
  std::string text;
  for (const FoundLight& found : vertex.found) text += line("light found", found_text(scene, found));
  if (!vertex.emission) return text + line("light found", "not counted at this depth");
  if (vertex.found.empty()) return line("light found", "none, beyond what light samples count");
  return text + line("adds", term_text(*vertex.emission));
}

std::string sample_text(const Scene& scene, const LoggedLightSample& logged) {
  const TakenLightSample& taken = logged.taken;
  const LightSample& sample = taken.sample;
  const bool is_group = taken.source >= scene.lights.size();
  if (is_black(sample.radiance) && is_group) return "one of many: none sends light here";
  const std::string name = light_text(scene, is_group ? sample.light : taken.source);
  if (is_black(sample.radiance)) return name + ": sends no light here";
  const std::string text = fmt::format("{}{}: along {}, radiance {}, density {}, MIS weight {}", name,
                                       is_group ? ", one of many" : "", text_of(sample.direction),
                                       text_of(sample.radiance), sample.pdf, logged.weight);
  if (is_black(taken.scattered)) return text + "; the surface scatters none of it: no shadow ray";
  if (is_black(taken.visibility)) return text + "; blocked";
  const std::string dimmed = taken.visibility == Rgb{1, 1, 1}
                                 ? ""
                                 : fmt::format(", {} let through on the way", text_of(taken.visibility));
  return text + fmt::format("; visible{}, scattered {}", dimmed, text_of(taken.scattered / sample.pdf));
}

std::string direction_text(const Scene& scene, const TakenDirection& taken) {
  const std::string text = fmt::format("along {}, density {}: ", text_of(taken.direction), taken.pdf);
  if (is_black(taken.radiance)) return text + "no light";
  return text + fmt::format("{}, radiance {}, f |cos| {}", light_text(scene, taken.light),
                            text_of(taken.radiance), text_of(taken.scattered));
}

std::string direct_text(const Scene& scene, const PathVertex& vertex) {
  std::string text;
  for (const LoggedLightSample& logged : vertex.light_samples)
    text += line("light sample", sample_text(scene, logged));
  for (const TakenDirection& taken : vertex.directions)
    text += line("direction", direction_text(scene, taken));
  if (!vertex.direct_light) return text;
  return text + line("adds", term_text(*vertex.direct_light));
}

std::string scattering_text(const PathVertex& vertex) {
  if (!vertex.scattering) return "";
  const Interaction& at = *vertex.surface;
  const auto& [sample, next] = *vertex.scattering;
  if (!next) return line("goes on", "no: nothing is scattered in the direction that was drawn");
  std::string text =
      line("goes on", fmt::format("by {} along {}", event_name(at, *next), text_of(next->direction)));
  text += line(sample.is_delta ? "probability" : "density", fmt::format("{}", sample.pdf));
  if (!at.is_in_medium())
    text += line("f", text_of(sample.value) + fmt::format(", |cos| {}", at.cosine(sample)));
  if (sample.eta != 1) text += line("refraction", fmt::format("relative index {}", sample.eta));
  text += line("throughput", text_of(next->throughput) + " behind it");
  if (!vertex.roulette) return text;
  const RouletteGame& game = *vertex.roulette;
  const std::string odds = fmt::format("goes on with probability {}, drew {}: ", game.probability, game.draw);
  return text + line("roulette", odds + (game.is_survived() ? "yes, throughput " + text_of(game.throughput)
                                                            : std::string("no")));
}

std::string point_text(const Scene& scene, const PathVertex& vertex) {
  const Interaction& at = *vertex.surface;
  const SurfacePoint& point = at.point();
  const Material& material = scene.materials[at.material()];
  std::string text = line("point", text_of(point.position));
  if (at.is_in_medium())
    return text +
           line("medium", fmt::format("within \"{}\", scattering {}, absorption {}, anisotropy {}",
                                      material.name, text_of(material.interior.scattering),
                                      text_of(material.interior.absorption), material.interior.anisotropy));
  text += line("geometric normal", text_of(point.geometric_normal));
  text += line("shading normal", text_of(at.normal()) + ", on the viewer's side");
  text += line("uv", fmt::format("{} {}", point.uv.x, point.uv.y));
  text += line("material", fmt::format("\"{}\", {}, albedo {}{}", material.name,
                                       words_of(type_of(material.model)), text_of(at.albedo()),
                                       vertex.materials == Materials::regularized ? ", regularized" : ""));
  return text;
}

/// Who let so much through.
const char* passed_text(const PathArrival& arrival, bool is_in_medium) {
  if (arrival.events_below) return " by the body, over the density of the walk";
  if (is_in_medium) return " by bodies on the way, over the density of this point";
  return arrival.is_flight ? " by bodies on the way, over the probability that they scatter nothing"
                           : " by bodies on the way";
}

std::string vertex_text(const Scene& scene, const PathVertex& vertex, std::size_t number) {
  const PathArrival& arrival = vertex.arrival;
  const bool is_in_medium = vertex.surface && vertex.surface->is_in_medium();
  std::string text = fmt::format("\nVertex {}: ", number);
  if (is_in_medium)
    text += fmt::format("in a medium, {} along the way\n",
                        length(vertex.surface->point().position - arrival.ray.origin));
  else if (arrival.events_below)
    text += fmt::format("out of the body, after {} scattering{} below its surface\n", *arrival.events_below,
                        *arrival.events_below == 1 ? "" : "s");
  else if (arrival.hit.is_miss())
    text += "none, the ray leaves the scene\n";
  else
    text += fmt::format("{}, at t = {}\n", shape_text(scene, arrival.hit), arrival.hit.t);
  if (arrival.transmittance != Rgb{1, 1, 1})
    text += line(is_in_medium ? "scattered" : "let through",
                 text_of(arrival.transmittance) + passed_text(arrival, is_in_medium));
  if (vertex.glow) text += line("media glow", "adds " + term_text(*vertex.glow));
  text += line("throughput", text_of(arrival.throughput));
  if (!is_in_medium && !arrival.events_below) text += emission_text(scene, vertex);
  if (!vertex.surface) return text;
  return text + point_text(scene, vertex) + direct_text(scene, vertex) + scattering_text(vertex);
}

}  // namespace

std::string event_name(const Interaction& at, const Scattering& next) {
  if (at.is_in_medium()) return "scattering in a medium";
  if (next.is_below) return "entering the body";
  const bool is_delta = next.departure.seeking == Seeking::alone;
  if (next.kind == ScatterKind::transmission) return is_delta ? "smooth transmission" : "rough transmission";
  if (is_delta) return "mirror reflection";
  return next.kind == ScatterKind::diffuse ? "diffuse reflection" : "glossy reflection";
}

std::string end_text(PathEnd end) {
  switch (end) {
    case PathEnd::left:
      return "the ray leaves the scene";
    case PathEnd::depth:
      return "it has been scattered as often as it may be";
    case PathEnd::absorbed:
      return "the surface scatters nothing where it would have gone on";
    case PathEnd::roulette:
      return "roulette";
    case PathEnd::below:
      return "it does not come out of the body";
    case PathEnd::unlit:
      return "it may not be scattered again, and a ray alone would find no light beyond what light samples "
             "count";
  }
  return "unknown";
}

std::string replay_text(const ReplayedSample& replayed) {
  const RenderOptions& render = replayed.arguments.render;
  const Replay& made = replayed.replay;
  std::string text = fmt::format(
      "Pixel {} {}, sample {} of {}: {}, {} x {} pixels, seed {}, sampler {}\n"
      "(points and directions are x y z, colours red green blue, densities per steradian)\n\n"
      "Camera\n",
      replayed.place().x, replayed.place().y, replayed.place().index, render.samples,
      replayed.arguments.scene, render.width, render.height, render.seed, sampler_name(render.sampler));
  if (replayed.time) text += line("time", fmt::format("{:g} s", *replayed.time));
  text += line("ray", fmt::format("from {} along {}", text_of(made.sample.ray.origin),
                                  text_of(made.sample.ray.direction)));
  if (made.sample.weight != 1)
    text += line("weight",
                 fmt::format("{}, of the pixel filter {}", made.sample.weight, filter_text(render.filter)));
  if (made.sample.light != 1)
    text += line("lens",
                 fmt::format("lets {} of the light through, over the density of this ray; what follows is "
                             "the light before it",
                             made.sample.light));
  std::size_t number = 0;
  for (const PathVertex& vertex : made.path.vertices()) text += vertex_text(replayed.scene, vertex, ++number);
  return text + fmt::format("\nThe path ends: {}.\nAll that it adds   {}\nRendered sample    {}\n",
                            end_text(made.path.end()), text_of(made.path.sum()), text_of(made.radiance));
}

}  // namespace twinray
