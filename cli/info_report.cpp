// SPDX-License-Identifier: Apache-2.0
#include "cli/info_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/counted.h"

namespace twinray {
namespace {

using Json = nlohmann::ordered_json;

/// So many are named in text.
constexpr std::size_t most_lines = 20;

Json json_of(const Rgb& color) { return {color.r, color.g, color.b}; }
Json json_of(const Vec3& point) { return {point.x, point.y, point.z}; }

Json json_of(const LightSummary& light) {
  return {{"name", light.name},
          {"kind", light.kind},
          {"quantity", light.quantity},
          {"amount", json_of(light.amount)},
          {"power", is_black(light.power) ? Json() : json_of(light.power)}};
}

Json json_of(const MaterialInfo& material) {
  return {{"name", material.name},
          {"model", material.model},
          {"textures", material.textures},
          {"shapes", material.shapes},
          {"triangles", material.triangles}};
}

Json json_of(const PictureInfo& picture) {
  return {
      {"name", picture.name}, {"width", picture.width}, {"height", picture.height}, {"bytes", picture.bytes}};
}

Json memory_json(const SceneInfo& info) {
  Json needs = {{"geometry", info.geometry_bytes}};
  std::uint64_t pictures = 0, sum = info.geometry_bytes;
  for (const PictureInfo& picture : info.pictures) pictures += picture.bytes;
  needs["pictures of surfaces"] = pictures;
  needs["pictures of lights"] = info.light_picture_bytes;
  needs["densities of media"] = info.density_bytes;
  needs["measured materials"] = info.measurement_bytes;
  sum += pictures + info.light_picture_bytes + info.density_bytes + info.measurement_bytes;
  for (const MemoryNeed& need : info.needs) {
    needs[need.name] = need.bytes;
    sum += need.bytes;
  }
  needs["all"] = sum;
  return needs;
}

template <typename Items>
Json list(const Items& items) {
  Json array = Json::array();
  for (const auto& item : items) array.push_back(json_of(item));
  return array;
}

Json json_of(const SceneInfo& info) {
  const SceneSummary& summary = info.summary;
  Json report;
  report["scene"] = info.scene;
  report["files"] = info.files;
  report["unit"] =
      summary.unit_name.empty() ? Json() : Json{{"name", summary.unit_name}, {"meters", summary.unit_meters}};
  report["camera"] = summary.camera.empty() ? Json() : Json(summary.camera);
  report["cameras"] = summary.cameras;
  report["bounds"] = summary.triangles + summary.spheres == 0
                         ? Json()
                         : Json{{"min", json_of(info.bounds.lower)}, {"max", json_of(info.bounds.upper)}};
  report["meshes"] = summary.meshes;
  report["triangles"] = summary.triangles;
  report["cut_out_triangles"] = info.cut_out_triangles;
  report["degenerate_triangles"] = summary.dropped_triangles;
  report["spheres"] = summary.spheres;
  report["prototypes"] = summary.prototypes;
  report["instances"] = summary.instances;
  report["seen_primitives"] = summary.seen_primitives;
  report["materials"] = list(info.materials);
  report["lights"] = list(summary.lights);
  report["pictures"] = list(info.pictures);
  report["media"] = {{"absorbing", info.media.absorbing},   {"scattering", info.media.scattering},
                     {"uneven", info.media.uneven},         {"glowing", info.media.glowing},
                     {"subsurface", info.media.subsurface}, {"atmosphere", info.media.has_atmosphere}};
  report["memory_bytes"] = memory_json(info);
  report["notes"] = summary.notes;
  report["warnings"] = info.warnings;
  return report;
}

template <typename Item, typename Size, typename Line>
void append(std::string& text, std::vector<Item> items, const Size& size, const Line& line) {
  std::stable_sort(items.begin(), items.end(),
                   [&](const Item& a, const Item& b) { return size(a) > size(b); });
  for (std::size_t i = 0; i < std::min(most_lines, items.size()); ++i) text += line(items[i]) + "\n";
  if (items.size() > most_lines)
    text += fmt::format("... and {} more, which --json names\n", items.size() - most_lines);
}

std::string line_of(const MaterialInfo& material) {
  return fmt::format("material \"{}\": {}, {}, {}{}", material.name, material.model,
                     counted(material.shapes, "shape"), counted(material.triangles, "triangle"),
                     material.textures > 0 ? ", " + counted(material.textures, "texture") : "");
}

std::string line_of(const PictureInfo& picture) {
  return fmt::format("picture \"{}\": {} x {} pixels, {}", picture.name, picture.width, picture.height,
                     bytes_text(picture.bytes));
}

/// Of what fills bodies; empty where nothing does.
std::string line_of(const MediaInfo& media) {
  std::string text;
  if (media.absorbing + media.scattering > 0)
    text = fmt::format("media: {} that absorb, {} that scatter light, {} of them not even{}{}\n",
                       media.absorbing, media.scattering, media.uneven,
                       media.glowing > 0 ? fmt::format(", {} that emit light", media.glowing) : "",
                       media.has_atmosphere ? "; an atmosphere" : "");
  if (media.subsurface > 0)
    text += fmt::format("light below the surface: of {}\n", counted(media.subsurface, "material"));
  return text;
}

}  // namespace

std::string info_text(const SceneInfo& info) {
  std::string text;
  for (const std::string& line : summary_lines(info.summary)) text += line + "\n";
  if (info.summary.triangles + info.summary.spheres > 0)
    text +=
        fmt::format("bounds: {:g} {:g} {:g} to {:g} {:g} {:g}\n", info.bounds.lower.x, info.bounds.lower.y,
                    info.bounds.lower.z, info.bounds.upper.x, info.bounds.upper.y, info.bounds.upper.z);
  if (info.cut_out_triangles > 0)
    text +=
        fmt::format("cut out: {}, by the alpha of a texture\n", counted(info.cut_out_triangles, "triangle"));
  append(
      text, info.materials, [](const MaterialInfo& m) { return m.triangles; },
      [](const MaterialInfo& m) { return line_of(m); });
  append(
      text, info.pictures, [](const PictureInfo& p) { return p.bytes; },
      [](const PictureInfo& p) { return line_of(p); });
  text += line_of(info.media);
  const Json memory = memory_json(info);
  for (const auto& [name, bytes] : memory.items())
    if (bytes.get<std::uint64_t>() > 0)
      text += fmt::format("memory: {} for {}\n", bytes_text(bytes.get<std::uint64_t>()), name);
  for (const MemoryNeed& need : info.needs)
    if (!need.instead.empty()) text += fmt::format("memory: {}, for {}\n", need.instead, need.name);
  return text;
}

std::string info_json(const SceneInfo& info) {
  return json_of(info).dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace twinray
