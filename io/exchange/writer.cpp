// SPDX-License-Identifier: Apache-2.0
#include "io/exchange/writer.h"

#include <fmt/format.h>

#include <cmath>

#include "core/textured_material.h"
#include "io/exchange/json.h"
#include "io/output_file.h"
#include "io/picture/image_file.h"
#include "io/ply/ply.h"

namespace twinray {
namespace {

/// The picture that a light is made of; null for most.
const Image* picture_of(const Light& light) {
  if (const auto* source = std::get_if<EnvironmentLight>(&light.source)) return source->map.get();
  if (const auto* source = std::get_if<GoniometricLight>(&light.source)) return source->map.get();
  const auto* projection = std::get_if<ProjectionLight>(&light.source);
  return projection ? projection->picture.get() : nullptr;
}

Json camera_json(const Camera& camera) {
  const bool is_at_distance = camera.projection == Projection::perspective;
  Json json{{"type", projection_name(camera.projection)},
            {"position", json_of(camera.position)},
            {"right", json_of(camera.right)},
            {"up", json_of(camera.up)},
            {"forward", json_of(camera.forward)},
            {is_at_distance ? "tan_half_width" : "half_width", json_of(camera.tan_half_width)},
            {is_at_distance ? "tan_half_height" : "half_height", json_of(camera.tan_half_height)},
            {"lens_radius", json_of(camera.lens_radius)},
            {"focal_distance", json_of(camera.focal_distance)},
            {"clip_near", json_of(camera.clip_near)}};
  if (camera.frame_center != Vec2{0, 0}) json["frame_center"] = json_of(camera.frame_center);
  if (camera.aperture_blades > 0)
    json["aperture"] = {{"blades", camera.aperture_blades}, {"turns", json_of(camera.aperture_turns)}};
  if (std::isfinite(camera.clip_far)) json["clip_far"] = json_of(camera.clip_far);
  json["clip_along"] = camera.clips_by_distance || is_panorama(camera.projection) ? "ray" : "forward";
  return json;
}

/// A light of a picture has, on a mesh, its mean radiance.
Json source_json(const LightSource& source) {
  if (const auto* mesh = std::get_if<MeshLight>(&source))
    return described(MeshLight{mesh->shape, mean_radiance(*mesh), mesh->side});
  return std::visit([](const auto& other) { return described(other); }, source);
}

Json model_json(const SurfaceModel& model) {
  return std::visit([](const auto& m) { return described(m); }, model);
}

Json shape_json(const Mesh&) { return {{"type", "mesh"}}; }
Json shape_json(const SphereSet& set) {
  Json spheres = Json::array();
  for (const Sphere& sphere : set.spheres)
    spheres.push_back({json_of(sphere.center.x), json_of(sphere.center.y), json_of(sphere.center.z),
                       json_of(sphere.radius)});
  return {{"type", "spheres"}, {"spheres", spheres}};
}

/// A name and, behind it, what the entry is.
Json named(const std::string& name, const Json& entry) {
  Json json{{"name", name}};
  json.update(entry);
  return json;
}

Json material_json(const Material& material) {
  Json json = named(material.name, model_json(material.model));
  for (const TextureUse& use : material.textures) json["textured"].push_back(input_name(use.input));
  if (material.normal_map != no_texture) json["textured"].push_back("normal_map");
  if (material.bump_map != no_texture) json["textured"].push_back("bump_map");
  if (Interior interior = material.interior; has_interior(material))
    members(MemberWriter(json["interior"]), interior);
  return json;
}

Json materials_json(const Scene& scene) {
  Json list = Json::array();
  for (const Material& material : scene.materials) list.push_back(material_json(material));
  return list;
}

Json lights_json(const Scene& scene, const std::string& path) {
  Json list = Json::array();
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const Light& light = scene.lights[i];
    list.push_back(named(light.name, source_json(light.source)));
    if (picture_of(light)) list.back()["file"] = name_of_file(exchange_light_file(path, i));
  }
  return list;
}

Json shapes_json(const Scene& scene, const std::string& path) {
  Json list = Json::array();
  const std::vector<Shape>& shapes = scene.geometry->shapes();
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    list.push_back(
        std::visit([](const auto& shape) { return named(shape.name, shape_json(shape)); }, shapes[i]));
    if (std::holds_alternative<Mesh>(shapes[i]))
      list.back()["file"] = name_of_file(exchange_mesh_file(path, i));
    list.back()["material"] = scene.bindings[i].material;
    if (scene.bindings[i].light != no_light) list.back()["light"] = scene.bindings[i].light;
    if (scene.bindings[i].alpha != no_texture) list.back()["textured"].push_back("alpha");
  }
  const std::vector<ShapeRange>& prototypes = scene.geometry->prototypes();
  for (std::size_t i = 0; i < prototypes.size(); ++i)
    for (std::uint32_t shape = prototypes[i].first; shape < prototypes[i].end(); ++shape)
      list[shape]["prototype"] = i;
  return list;
}

/// With all digits of a double: rays are transformed by these numbers.
Json instances_json(const Scene& scene) {
  Json list = Json::array();
  for (const auto& [prototype, to_world] : scene.geometry->instances()) {
    Json rows = Json::array();
    for (const auto& row : to_world.m) rows.push_back(row);
    list.push_back({{"prototype", prototype}, {"to_world", rows}});
  }
  return list;
}

/// On one line. A name may hold bytes that are no letters.
std::string line(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

/// A list with a line for each entry.
std::string lines(const Json& list) {
  std::string text = "[";
  for (const Json& entry : list) text += (text.size() > 1 ? ",\n    " : "\n    ") + line(entry);
  return text + (list.empty() ? "]" : "\n  ]");
}

}  // namespace

std::string type_of(const SurfaceModel& model) {
  return std::visit([](const auto& m) { return type_name(m); }, model);
}

std::string type_of(const LightSource& source) {
  return std::visit([](const auto& s) { return type_name(s); }, source);
}

std::string exchange_json(const Scene& scene, const std::string& path, const ExchangeFrame& frame) {
  const Camera camera = fit_frame(scene.camera, frame.width, frame.height);
  const bool has_instances = scene.geometry->has_instances();
  return fmt::format(
      "{{\n  \"format\": \"twinray scene\",\n  \"version\": {},\n  \"resolution\": [{},{}],\n"
      "  \"camera\": {},\n  \"materials\": {},\n  \"lights\": {},\n  \"shapes\": {}{}\n}}\n",
      has_instances ? 2 : 1, frame.width, frame.height, line(camera_json(camera)),
      lines(materials_json(scene)), lines(lights_json(scene, path)), lines(shapes_json(scene, path)),
      has_instances ? ",\n  \"instances\": " + lines(instances_json(scene)) : "");
}

namespace {

/// What the form does not hold.
Losses losses_of(const Scene& scene) {
  Losses losses;
  for (const Material& material : scene.materials)
    if (!material.textures.empty() || material.normal_map != no_texture || material.bump_map != no_texture)
      losses.add("a material loses its textures: what is the same everywhere stands in their place",
                 "{} materials lose their textures: what is the same everywhere stands in their place");
  for (const ShapeBinding& binding : scene.bindings)
    if (binding.alpha != no_texture) losses.add("a shape loses its holes", "{} shapes lose their holes");
  for (const Light& light : scene.lights)
    if (const auto* mesh = std::get_if<MeshLight>(&light.source); mesh && mesh->picture)
      losses.add("an area light has the mean of its picture",
                 "{} area lights have the means of their pictures");
  return losses;
}

}  // namespace

WrittenScene written_exchange(const SceneToWrite& input, const std::string& path) {
  const Scene& scene = input.scene;
  WrittenScene written{.files = {}, .warnings = losses_of(scene).lines(path)};
  for (std::size_t i = 0; i < scene.geometry->shapes().size(); ++i)
    if (const Mesh* mesh = scene.geometry->mesh(std::uint32_t(i)))
      written.files.push_back({exchange_mesh_file(path, i),
                               [mesh](const std::string& file) { write_file(file, ply_bytes(*mesh)); }});
  for (std::size_t i = 0; i < scene.lights.size(); ++i)
    if (const Image* picture = picture_of(scene.lights[i]))
      written.files.push_back(
          {exchange_light_file(path, i), [picture](const std::string& file) { write_exr(file, *picture); }});
  const ExchangeFrame frame{input.picture.resolution->width, input.picture.resolution->height};
  written.files.push_back({path, [&scene, path, frame](const std::string& file) {
                             write_file(file, exchange_json(scene, path, frame));
                           }});
  return written;
}

}  // namespace twinray
