// SPDX-License-Identifier: Apache-2.0
#include "io/collada.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/collada_camera.h"
#include "io/collada_lamp.h"
#include "io/collada_nodes.h"
#include "io/collada_schema.h"

namespace twinray {
namespace {

/// Area lights become shapes like any other, of a material that reflects nothing.
void add_rectangles(SceneParts& parts, ColladaMaterials& materials) {
  for (const AreaLight& light : parts.area_lights)
    parts.shapes.push_back(
        {area_light_mesh(light), materials.black(), light.radiance, EmissionSide::front, light.name});
}

LightSource shape_light(const ScenePart& part, std::uint32_t shape) {
  if (std::holds_alternative<SphereSet>(part.shape)) return SphereLight{shape, part.radiance};
  return MeshLight{shape, part.radiance, part.side};
}

/// Lights of shapes come first, in the order of their shapes.
Scene assemble(SceneParts parts, const ColladaMaterials& materials) {
  Scene scene;
  std::vector<Shape> shapes;
  for (ScenePart& part : parts.shapes) {
    ShapeBinding binding{part.material, no_light};
    if (!is_black(part.radiance)) {
      binding.light = std::uint32_t(scene.lights.size());
      scene.lights.push_back({part.light_name, shape_light(part, std::uint32_t(shapes.size()))});
    }
    scene.bindings.push_back(binding);
    shapes.push_back(std::move(part.shape));
  }
  scene.lights.insert(scene.lights.end(), parts.lights.begin(), parts.lights.end());
  scene.materials = materials.materials();
  scene.geometry = std::make_shared<const Geometry>(std::move(shapes));
  check_scene(scene);
  return scene;
}

std::string specular_note(const std::vector<std::string>& names) {
  std::string list;
  for (std::size_t i = 0; i < names.size(); ++i)
    list += fmt::format("{}\"{}\"", i == 0 ? "" : ", ", names[i]);
  return fmt::format("materials reflect evenly (Lambert); the specular color of {} is left out", list);
}

XmlElement find_visual_scene(const ColladaDocument& document) {
  const XmlElement scene = document.root().required_child("scene");
  return document.resolve(scene.required_child("instance_visual_scene"), "url", "visual_scene");
}

LoadedScene read_document(ColladaDocument& document) {
  check_names(document);
  const XmlElement visual_scene = find_visual_scene(document);
  ColladaMaterials materials(document);
  ColladaNodes nodes(document, materials);
  nodes.walk(visual_scene, document.to_y_up());
  if (nodes.parts.shapes.empty()) document.warn(visual_scene, "the scene has no shapes");
  if (!document.options().keep_both_lamps) merge_lamps(nodes.parts);
  add_rectangles(nodes.parts, materials);

  LoadedScene loaded;
  SceneSummary& summary = loaded.summary;
  summary.notes = nodes.parts.notes;
  if (!materials.with_specular().empty()) summary.notes.push_back(specular_note(materials.with_specular()));
  const Aabb bounds = nodes.parts.bounds;
  loaded.scene = assemble(std::move(nodes.parts), materials);
  if (document.options().interpretation == Interpretation::cs184)
    loaded.scene.camera = cs184_camera(nodes.cs184_view, bounds);
  else
    loaded.scene.camera = nodes.camera.value_or(default_camera(loaded.scene.geometry->bounds()));
  summary.camera = nodes.camera_name;
  summary.unit_name = document.unit_name();
  summary.unit_meters = document.unit_meters();
  summary.up_axis = document.up_axis();
  summary.dropped_triangles = nodes.dropped_triangles;
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

LoadedScene read_collada(const XmlDocument& xml, const LoadOptions& options) {
  ColladaDocument document(xml, options);
  try {
    return read_document(document);
  } catch (const Error& error) {
    throw Error(with_warnings(error, document.warnings()));
  }
}

}  // namespace twinray
