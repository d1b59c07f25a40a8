// SPDX-License-Identifier: Apache-2.0
#include "io/collada/collada.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/collada/camera.h"
#include "io/collada/cameras.h"
#include "io/collada/lamp.h"
#include "io/collada/node_tree.h"
#include "io/collada/nodes.h"
#include "io/default_camera.h"

namespace twinray {
namespace {

/// Area lights become shapes like any other, of a material that reflects nothing.
void add_rectangles(SceneParts& parts, ColladaMaterials& materials) {
  for (const AreaLight& light : parts.area_lights)
    parts.shapes.push_back({.shape = area_light_mesh(light),
                            .material = materials.black(),
                            .glow = {.radiance = light.radiance, .side = EmissionSide::front},
                            .light_name = light.name});
}

/// "a", "b": the first of them, and how many more there are.
std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t most = 20;
  std::string list;
  for (std::size_t i = 0; i < std::min(names.size(), most); ++i)
    list += fmt::format("{}\"{}\"", i == 0 ? "" : ", ", names[i]);
  return names.size() > most ? fmt::format("{} and {} more", list, names.size() - most) : list;
}

/// The names that lights still have: a lamp may have taken the place of one.
std::vector<std::string> names_among(const std::vector<std::string>& names,
                                     const std::vector<Light>& lights) {
  std::vector<std::string> found;
  for (const std::string& name : names)
    if (std::any_of(lights.begin(), lights.end(), [&](const Light& light) { return light.name == name; }))
      found.push_back(name);
  return found;
}

std::string attenuation_note(const std::vector<std::string>& names) {
  return fmt::format(
      "the file says nothing of how light falls off with the distance d for {}: it falls off as 1/d^2, with "
      "d "
      "in the file's unit; --attenuation=file gives COLLADA's default, no fall-off",
      listed(names));
}

std::string specular_note(const std::vector<std::string>& names) {
  return fmt::format("materials reflect evenly (Lambert); the specular color of {} is left out",
                     listed(names));
}

std::string hidden_note(const std::vector<std::string>& names) {
  return fmt::format("hidden by the file, and left out: {}", listed(names));
}

/// The first <visual_scene> of the file, where nothing says which one is to be seen.
XmlElement first_visual_scene(ColladaDocument& document) {
  std::vector<XmlElement> scenes;
  for (const XmlElement& library : document.root().children("library_visual_scenes"))
    for (const XmlElement& scene : library.children("visual_scene")) scenes.push_back(scene);
  if (scenes.empty())
    document.root().fail("the file has no <visual_scene>: it may hold geometry, and places none of it");
  document.warn(scenes[0],
                fmt::format("no <instance_visual_scene> says which scene is seen; this is the first of {}",
                            scenes.size()));
  return scenes[0];
}

XmlElement find_visual_scene(ColladaDocument& document) {
  const auto scene = document.root().child("scene");
  const auto instance = scene ? scene->child("instance_visual_scene") : std::nullopt;
  return instance ? document.resolve(*instance, "url", "visual_scene") : first_visual_scene(document);
}

/// `bounds` is the box that CS184's program sees.
Camera camera_of(const ColladaCamera* chosen, const Aabb& bounds, const Geometry& geometry,
                 ColladaDocument& document) {
  if (document.options().interpretation == Interpretation::cs184)
    return cs184_camera(chosen ? cs184_view_of(*chosen, document) : Cs184View{}, bounds);
  return chosen ? place_camera(*chosen, document) : default_camera(geometry.bounds());
}

LoadedScene read_document(ColladaDocument& document, const PictureReader& read_picture) {
  document.check_names_of(document.root());
  const ColladaSpace& space = document.space_of(document.root());
  const XmlElement visual_scene = find_visual_scene(document);
  ColladaMaterials materials(document, read_picture);
  ColladaNodes nodes(document, materials);
  check_node_tree(visual_scene, document);
  nodes.walk(visual_scene, turn_to_y_up(space.up_axis));
  if (nodes.parts.shapes.empty()) document.warn(visual_scene, "the scene has no shapes");
  LoadedScene loaded;
  SceneSummary& summary = loaded.summary;
  summary.has_double_lamps = has_double_lamps(nodes.parts);
  if (!document.options().keep_both_lamps) merge_lamps(nodes.parts);
  add_rectangles(nodes.parts, materials);
  summary.notes = nodes.parts.notes;
  if (!nodes.hidden.empty()) summary.notes.push_back(hidden_note(nodes.hidden));
  if (const auto names = names_among(nodes.without_attenuation, nodes.parts.lights); !names.empty())
    summary.notes.push_back(attenuation_note(names));
  if (!materials.with_specular().empty()) summary.notes.push_back(specular_note(materials.with_specular()));
  const Aabb bounds = nodes.parts.bounds;
  Scene rest;
  rest.materials = materials.materials();
  rest.textures = materials.textures();
  rest.lights = std::move(nodes.parts.lights);
  rest.assets = std::move(nodes.parts.assets);
  loaded.scene = assemble(std::move(nodes.parts.shapes), std::move(rest), std::move(nodes.parts.instances));
  const ColladaCamera* camera = choose_camera(nodes.cameras, visual_scene, document);
  if (camera) summary.camera = camera_name(*camera);
  loaded.scene.camera = camera_of(camera, bounds, *loaded.scene.geometry, document);
  if (camera)
    if (const auto note = unused_clip_note(*camera, loaded.scene, document)) summary.notes.push_back(*note);
  for (const ColladaCamera& each : nodes.cameras) summary.cameras.push_back(camera_name(each));
  summary.unit_name = space.unit_name;
  summary.unit_meters = space.unit_meters;
  summary.up_axis = space.up_axis;
  summary.dropped_triangles = nodes.dropped_triangles();
  summary.repeated = nodes.repeated();
  count_scene(loaded.scene, summary);
  loaded.warnings = document.warnings();
  return loaded;
}

/// A mistyped name is often why something seems to be missing.
std::string with_warnings(const Error& error, const std::vector<Diagnostic>& warnings) {
  constexpr std::size_t most = 3;
  std::string text = error.what();
  for (std::size_t i = 0; i < std::min(warnings.size(), most); ++i)
    text += "\nnoticed before: " + warnings[i].text();
  return text;
}

}  // namespace

LoadedScene read_collada(const XmlDocument& xml, const LoadOptions& options, const ColladaFiles& files) {
  ColladaDocument document(xml, options, files.document);
  try {
    return read_document(document, files.picture);
  } catch (const Error& error) {
    throw Error(with_warnings(error, document.warnings()));
  }
}

}  // namespace twinray
