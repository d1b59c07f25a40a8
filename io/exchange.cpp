// SPDX-License-Identifier: Apache-2.0
#include "io/exchange.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/textured_material.h"
#include "io/output_file.h"
#include "io/picture/image_file.h"
#include "io/ply/ply.h"

namespace twinray {
namespace {

constexpr std::string_view ending = ".json";

/// Objects keep their order; a number is a float, and has its digits.
using Json = nlohmann::basic_json<nlohmann::ordered_map, std::vector, std::string, bool, std::int64_t,
                                  std::uint64_t, float>;

Json json_of(const Vec3& v) { return {v.x, v.y, v.z}; }
Json json_of(const Rgb& color) { return {color.r, color.g, color.b}; }

/// "room.json" and "-3.ply" -> "room-3.ply".
std::string beside(const std::string& path, const std::string& suffix) {
  return path.substr(0, path.size() - ending.size()) + suffix;
}
std::string mesh_file(const std::string& path, std::size_t shape) {
  return beside(path, fmt::format("-{}.ply", shape));
}
std::string light_file(const std::string& path, std::size_t light) {
  return beside(path, fmt::format("-light-{}.exr", light));
}

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
            {is_at_distance ? "tan_half_width" : "half_width", camera.tan_half_width},
            {is_at_distance ? "tan_half_height" : "half_height", camera.tan_half_height},
            {"lens_radius", camera.lens_radius},
            {"focal_distance", camera.focal_distance},
            {"clip_near", camera.clip_near}};
  if (camera.frame_center != Vec2{0, 0})
    json["frame_center"] = {camera.frame_center.x, camera.frame_center.y};
  if (camera.aperture_blades > 0)
    json["aperture"] = {{"blades", camera.aperture_blades}, {"turns", camera.aperture_turns}};
  if (std::isfinite(camera.clip_far)) json["clip_far"] = camera.clip_far;
  json["clip_along"] = camera.clips_by_distance || is_panorama(camera.projection) ? "ray" : "forward";
  return json;
}

Json model_json(const Lambert& model) {
  return {{"type", "lambert"}, {"reflectance", json_of(model.reflectance)}};
}
Json model_json(const Mirror& model) {
  return {{"type", "mirror"}, {"reflectance", json_of(model.reflectance)}};
}
Json model_json(const Refraction& model) {
  return {{"type", "refraction"},
          {"transmittance", json_of(model.transmittance)},
          {"roughness", model.roughness},
          {"ior", model.ior}};
}
Json model_json(const Glass& model) {
  return {{"type", "glass"},
          {"transmittance", json_of(model.transmittance)},
          {"reflectance", json_of(model.reflectance)},
          {"roughness", model.roughness},
          {"ior", model.ior}};
}
Json model_json(const Microfacet& model) {
  return {{"type", "microfacet"},
          {"distribution", "beckmann"},
          {"alpha", model.alpha},
          {"eta", json_of(model.eta)},
          {"k", json_of(model.k)}};
}
Json json_of(const Roughness& roughness) { return {roughness.x, roughness.y}; }
Json model_json(const Dielectric& model) {
  return {{"type", model.is_thin ? "thin_dielectric" : "dielectric"},
          {"ior", model.ior},
          {"alpha", json_of(model.roughness)},
          {"reflectance", json_of(model.reflectance)},
          {"transmittance", json_of(model.transmittance)}};
}
Json model_json(const Conductor& model) {
  return {{"type", "conductor"},
          {"eta", json_of(model.eta)},
          {"k", json_of(model.k)},
          {"alpha", json_of(model.roughness)},
          {"reflectance", json_of(model.reflectance)}};
}
Json model_json(const DiffuseTransmission& model) {
  return {{"type", "diffuse_transmission"},
          {"reflectance", json_of(model.reflectance)},
          {"transmittance", json_of(model.transmittance)}};
}
Json model_json(const RoughDiffuse& model) {
  return {
      {"type", "rough_diffuse"}, {"reflectance", json_of(model.reflectance)}, {"roughness", model.roughness}};
}
Json model_json(const CoatedDiffuse& model) {
  return {{"type", "coated_diffuse"},
          {"reflectance", json_of(model.reflectance)},
          {"alpha", json_of(model.roughness)},
          {"ior", model.ior}};
}
Json model_json(const CoatedConductor& model) {
  return {{"type", "coated_conductor"},
          {"eta", json_of(model.eta)},
          {"k", json_of(model.k)},
          {"alpha", json_of(model.roughness)},
          {"reflectance", json_of(model.reflectance)},
          {"coat_alpha", json_of(model.coat_roughness)},
          {"coat_ior", model.coat_ior}};
}
Json model_json(const Principled& m) {
  return {{"type", "openpbr"},
          {"base_weight", m.base_weight},
          {"base_color", json_of(m.base_color)},
          {"base_diffuse_roughness", m.base_diffuse_roughness},
          {"base_metalness", m.base_metalness},
          {"specular_weight", m.specular_weight},
          {"specular_color", json_of(m.specular_color)},
          {"specular_roughness", m.specular_roughness},
          {"specular_roughness_anisotropy", m.specular_roughness_anisotropy},
          {"specular_ior", m.specular_ior},
          {"transmission_weight", m.transmission_weight},
          {"transmission_color", json_of(m.transmission_color)},
          {"transmission_depth", m.transmission_depth},
          {"coat_weight", m.coat_weight},
          {"coat_color", json_of(m.coat_color)},
          {"coat_roughness", m.coat_roughness},
          {"coat_ior", m.coat_ior},
          {"coat_darkening", m.coat_darkening},
          {"fuzz_weight", m.fuzz_weight},
          {"fuzz_color", json_of(m.fuzz_color)},
          {"fuzz_roughness", m.fuzz_roughness},
          {"emission_luminance", m.emission_luminance},
          {"emission_color", json_of(m.emission_color)},
          {"geometry_thin_walled", m.geometry_thin_walled}};
}
Json model_json(const Interface&) { return {{"type", "interface"}}; }
Json model_json(const Mix& model) {
  return {{"type", "mix"}, {"first", model.first}, {"second", model.second}, {"amount", model.amount}};
}

const char* side_name(EmissionSide side) {
  if (side == EmissionSide::both) return "both";
  return side == EmissionSide::front ? "front" : "back";
}

/// The three coefficients of the fall-off with distance.
Json json_of(const Attenuation& attenuation) {
  return {{"constant", attenuation.constant},
          {"linear", attenuation.linear},
          {"quadratic", attenuation.quadratic}};
}

Json source_json(const MeshLight& light) {
  return {{"type", "mesh"},
          {"shape", light.shape},
          {"radiance", json_of(mean_radiance(light))},
          {"side", side_name(light.side)}};
}
Json source_json(const SphereLight& light) {
  return {{"type", "sphere"}, {"shape", light.shape}, {"radiance", json_of(light.radiance)}};
}
Json source_json(const PointLight& light) {
  return {{"type", "point"},
          {"position", json_of(light.position)},
          {"intensity", json_of(light.intensity)},
          {"attenuation", json_of(light.attenuation)}};
}
Json source_json(const SpotLight& light) {
  return {{"type", "spot"},
          {"position", json_of(light.position)},
          {"direction", json_of(light.direction)},
          {"intensity", json_of(light.intensity)},
          {"attenuation", json_of(light.attenuation)},
          {"falloff_angle_degrees", light.falloff_angle_degrees},
          {"falloff_exponent", light.falloff_exponent},
          {"penumbra_degrees", light.penumbra_degrees}};
}
Json source_json(const DirectionalLight& light) {
  return {{"type", "directional"},
          {"direction", json_of(light.direction)},
          {"irradiance", json_of(light.irradiance)}};
}
Json source_json(const AmbientLight& light) {
  return {{"type", "ambient"}, {"up", json_of(light.up)}, {"radiance", json_of(light.radiance)}};
}
/// The columns of a rotation: where the axes of the picture's space point to.
Json rotation_json(const Transform& rotation) {
  return {{"x", json_of(rotation.vector({1, 0, 0}))},
          {"y", json_of(rotation.vector({0, 1, 0}))},
          {"z", json_of(rotation.vector({0, 0, 1}))}};
}
const char* layout_name(MapLayout layout) {
  return layout == MapLayout::equal_area ? "equal-area" : "latitude-longitude";
}
Json source_json(const EnvironmentLight& light) {
  return {{"type", "environment"},
          {"layout", layout_name(light.layout)},
          {"rotation", rotation_json(light.rotation)},
          {"scale", json_of(light.scale)}};
}
Json source_json(const GoniometricLight& light) {
  return {{"type", "goniometric"},
          {"position", json_of(light.position)},
          {"intensity", json_of(light.intensity)},
          {"layout", layout_name(light.layout)},
          {"rotation", rotation_json(light.rotation)}};
}
Json source_json(const ProjectionLight& light) {
  return {{"type", "projection"},
          {"position", json_of(light.position)},
          {"right", json_of(light.right)},
          {"up", json_of(light.up)},
          {"forward", json_of(light.forward)},
          {"tan_half_width", light.tan_half_width},
          {"tan_half_height", light.tan_half_height},
          {"intensity", json_of(light.intensity)}};
}
Json source_json(const SunLight& light) {
  return {{"type", "sun"},
          {"direction", json_of(light.direction)},
          {"irradiance", json_of(light.irradiance)},
          {"diameter_degrees", light.diameter_degrees}};
}

Json shape_json(const Mesh&) { return {{"type", "mesh"}}; }
Json shape_json(const SphereSet& set) {
  Json spheres = Json::array();
  for (const Sphere& sphere : set.spheres)
    spheres.push_back({sphere.center.x, sphere.center.y, sphere.center.z, sphere.radius});
  return {{"type", "spheres"}, {"spheres", spheres}};
}

/// A name and, behind it, what the entry is.
Json named(const std::string& name, const Json& entry) {
  Json json{{"name", name}};
  json.update(entry);
  return json;
}

Json material_json(const Material& material) {
  Json json =
      named(material.name, std::visit([](const auto& model) { return model_json(model); }, material.model));
  for (const TextureUse& use : material.textures) json["textured"].push_back(input_name(use.input));
  if (material.normal_map != no_texture) json["textured"].push_back("normal_map");
  if (material.bump_map != no_texture) json["textured"].push_back("bump_map");
  if (has_interior(material))
    json["interior"] = {{"absorption", json_of(material.interior.absorption)},
                        {"priority", material.interior.priority}};
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
    list.push_back(
        named(light.name, std::visit([](const auto& source) { return source_json(source); }, light.source)));
    if (picture_of(light)) list.back()["file"] = name_of_file(light_file(path, i));
  }
  return list;
}

Json shapes_json(const Scene& scene, const std::string& path) {
  Json list = Json::array();
  const std::vector<Shape>& shapes = scene.geometry->shapes();
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    list.push_back(
        std::visit([](const auto& shape) { return named(shape.name, shape_json(shape)); }, shapes[i]));
    if (std::holds_alternative<Mesh>(shapes[i])) list.back()["file"] = name_of_file(mesh_file(path, i));
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
  return std::visit([](const auto& m) { return model_json(m); }, model)["type"];
}

std::string type_of(const LightSource& source) {
  return std::visit([](const auto& s) { return source_json(s); }, source)["type"];
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

WrittenScene written_exchange(const SceneToWrite& input, const std::string& path) {
  WrittenScene written;
  const Scene& scene = input.scene;
  for (std::size_t i = 0; i < scene.geometry->shapes().size(); ++i)
    if (const Mesh* mesh = scene.geometry->mesh(std::uint32_t(i)))
      written.files.push_back(
          {mesh_file(path, i), [mesh](const std::string& file) { write_file(file, ply_bytes(*mesh)); }});
  for (std::size_t i = 0; i < scene.lights.size(); ++i)
    if (const Image* picture = picture_of(scene.lights[i]))
      written.files.push_back(
          {light_file(path, i), [picture](const std::string& file) { write_exr(file, *picture); }});
  const ExchangeFrame frame{input.picture.resolution->width, input.picture.resolution->height};
  written.files.push_back({path, [&scene, path, frame](const std::string& file) {
                             write_file(file, exchange_json(scene, path, frame));
                           }});
  return written;
}

}  // namespace twinray
