// SPDX-License-Identifier: Apache-2.0
#include "io/exchange/writer.h"
#include "io/exchange/camera.h"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "io/exchange/json.h"
#include "io/measured/brdf_file.h"
#include "io/output_file.h"
#include "io/picture/image_file.h"
#include "io/ply/ply.h"

namespace twinray {
namespace {

/// The picture that a light is made of; null for most.
const Image* picture_of(const Light& light) {
  if (const auto* source = std::get_if<MeshLight>(&light.source)) return source->picture.get();
  if (const auto* source = std::get_if<EnvironmentLight>(&light.source)) return source->map.get();
  if (const auto* source = std::get_if<GoniometricLight>(&light.source)) return source->map.get();
  const auto* projection = std::get_if<ProjectionLight>(&light.source);
  return projection ? projection->picture.get() : nullptr;
}

/// Of a texture, of a material's model or of a light's source.
template <typename Variant>
Json json_of_any(const Variant& variant) {
  return std::visit([](const auto& value) { return described(value); }, variant);
}

/// The picture of a texture; null for most.
const MipMap* picture_of(const Texture& texture) {
  const auto* image = std::get_if<ImageTexture>(&texture.model);
  return image ? image->image.get() : nullptr;
}

/// What a material was measured as; null for most.
const MeasuredBrdf* brdf_of(const Material& material) {
  const auto* measured = std::get_if<Measured>(&material.model);
  return measured ? measured->brdf.get() : nullptr;
}

/// Of each in a list the first one for which `of` gives the same: its number stands in the file's name.
template <typename Each, typename Of>
std::vector<std::size_t> first_of(const std::vector<Each>& list, const Of& of) {
  std::vector<std::size_t> first;
  std::map<decltype(of(list[0])), std::size_t> known;
  for (std::size_t i = 0; i < list.size(); ++i)
    first.push_back(known.try_emplace(of(list[i]), i).first->second);
  return first;
}
std::vector<std::size_t> first_of_picture(const Scene& scene) {
  return first_of(scene.textures, [](const Texture& texture) { return picture_of(texture); });
}
std::vector<std::size_t> first_of_brdf(const Scene& scene) { return first_of(scene.materials, brdf_of); }

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

Json textures_json(const Scene& scene, const std::string& path) {
  Json list = Json::array();
  const std::vector<std::size_t> first = first_of_picture(scene);
  for (std::size_t i = 0; i < scene.textures.size(); ++i) {
    const Texture& texture = scene.textures[i];
    list.push_back(named(texture.name, json_of_any(texture.model)));
    const MipMap* const picture = picture_of(texture);
    if (!picture) continue;
    list.back()["file"] = name_of_file(exchange_texture_file(path, first[i]));
    if (picture->levels() == 1) list.back()["mip_map"] = false;
    if (std::get<ImageTexture>(texture.model).of_vertices) list.back()["of_vertices"] = true;
  }
  return list;
}

Json glow_json(Glow glow) {
  Json json = Json::object();
  members(MemberWriter(json), glow);
  if (glow.factor != no_density) json["factor"] = glow.factor;
  if (glow.temperature != no_density) json["temperature"] = glow.temperature;
  return json;
}

Json material_json(const Material& material) {
  Json json = named(material.name, json_of_any(material.model));
  for (TextureUse use : material.textures) {
    Json& entry = json["textures"].emplace_back(Json::object());
    members(MemberWriter(entry), use);
  }
  if (material.normal_map != no_texture) json["normal_map"] = material.normal_map;
  if (material.bump_map != no_texture) json["bump_map"] = material.bump_map;
  if (material.tangent_degrees != 0) json["tangent_degrees"] = json_of(material.tangent_degrees);
  if (material.tangent_map != no_texture) json["tangent_map"] = material.tangent_map;
  if (Interior interior = material.interior; has_interior(material)) {
    members(MemberWriter(json["interior"]), interior);
    if (interior.density != no_density) json["interior"]["density"] = interior.density;
    if (interior.emits()) json["interior"]["glow"] = glow_json(interior.glow);
  }
  if (Subsurface subsurface = material.subsurface; has_subsurface(material))
    members(MemberWriter(json["subsurface"]), subsurface);
  return json;
}

Json materials_json(const Scene& scene, const std::string& path) {
  Json list = Json::array();
  const std::vector<std::size_t> first = first_of_brdf(scene);
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    list.push_back(material_json(scene.materials[i]));
    if (brdf_of(scene.materials[i])) list.back()["file"] = name_of_file(exchange_brdf_file(path, first[i]));
  }
  return list;
}

Json lights_json(const Scene& scene, const std::string& path) {
  Json list = Json::array();
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const Light& light = scene.lights[i];
    list.push_back(named(light.name, json_of_any(light.source)));
    if (picture_of(light)) list.back()["file"] = name_of_file(exchange_light_file(path, i));
    if (const auto* mesh = std::get_if<MeshLight>(&light.source); mesh && mesh->picture)
      picture_members(MemberWriter(list.back()), *mesh);
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
    if (scene.bindings[i].alpha != no_texture) list.back()["alpha"] = scene.bindings[i].alpha;
    if (scene.bindings[i].asset != no_asset) list.back()["asset"] = scene.assets[scene.bindings[i].asset];
  }
  const std::vector<ShapeRange>& prototypes = scene.geometry->prototypes();
  for (std::size_t i = 0; i < prototypes.size(); ++i)
    for (std::uint32_t shape = prototypes[i].first; shape < prototypes[i].end(); ++shape)
      list[shape]["prototype"] = i;
  return list;
}

/// With all digits of a double: rays are transformed by these numbers.
Json rows_of(const Transform& transform) {
  Json rows = Json::array();
  for (const auto& row : transform.m) rows.push_back(row);
  return rows;
}

Json instances_json(const Scene& scene) {
  Json list = Json::array();
  for (const auto& [prototype, to_world] : scene.geometry->instances())
    list.push_back({{"prototype", prototype}, {"to_world", rows_of(to_world)}});
  return list;
}

Json densities_json(const Scene& scene, const std::string& path) {
  Json list = Json::array();
  for (std::size_t i = 0; i < scene.densities.size(); ++i)
    list.push_back({{"size", scene.densities[i]->size()},
                    {"to_unit", rows_of(scene.densities[i]->to_unit())},
                    {"file", name_of_file(exchange_density_file(path, i))}});
  return list;
}

/// The slices of a grid, one above the other.
Image density_picture(const DensityGrid& grid) {
  const auto& [nx, ny, nz] = grid.size();
  Image picture(nx, ny * nz);
  for (int z = 0; z < nz; ++z)
    for (int y = 0; y < ny; ++y)
      for (int x = 0; x < nx; ++x) {
        const float value = grid.value(x, y, z);
        picture.at(x, z * ny + y) = {value, value, value};
      }
  return picture;
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

/// What else than its size the file says of the picture; nothing if it says nothing.
std::string render_text(const ExchangePicture& picture) {
  Json json = Json::object();
  if (picture.samples) json["samples"] = *picture.samples;
  if (picture.max_depth) json["max_depth"] = *picture.max_depth;
  if (std::optional<PixelFilter> filter = picture.filter) members(MemberWriter(json["filter"]), *filter);
  if (picture.crop) json["crop"] = *picture.crop;
  if (picture.daylight_kelvin) json["daylight_kelvin"] = *picture.daylight_kelvin;
  return json.empty() ? "" : fmt::format("  \"render\": {},\n", line(json));
}

/// Whether a texture is one of those that the third version has.
struct IsOfThirdVersion {
  template <typename Model>
  bool operator()(const Model&) const {
    return std::is_same_v<Model, ConstantTexture> || std::is_same_v<Model, ImageTexture> ||
           std::is_same_v<Model, ScaleTexture> || std::is_same_v<Model, MixTexture> ||
           std::is_same_v<Model, CheckerboardTexture>;
  }
};

/// The first version that has all that is in the scene.
int version_of(const Scene& scene) {
  for (const Texture& texture : scene.textures)
    if (!std::visit(IsOfThirdVersion{}, texture.model)) return 4;
  if (!scene.textures.empty()) return 3;
  return scene.geometry->has_instances() ? 2 : 1;
}

std::string exchange_json(const Scene& scene, const std::string& path, const ExchangePicture& picture) {
  const Camera camera = fit_frame(scene.camera, picture.width, picture.height);
  const bool has_instances = scene.geometry->has_instances(), has_textures = !scene.textures.empty();
  const bool has_atmosphere = scene.atmosphere != no_material;
  const auto list = [](const char* key, const Json& json) {
    return fmt::format(",\n  \"{}\": {}", key, lines(json));
  };
  return fmt::format("{{\n  \"format\": \"twinray scene\",\n  \"version\": {},\n  \"resolution\": [{},{}],\n",
                     version_of(scene), picture.width, picture.height) +
         render_text(picture) + "  \"camera\": " + line(exchange_camera_json(camera)) +
         (has_textures ? list("textures", textures_json(scene, path)) : "") +
         (scene.densities.empty() ? "" : list("densities", densities_json(scene, path))) +
         list("materials", materials_json(scene, path)) +
         (has_atmosphere ? fmt::format(",\n  \"atmosphere\": {}", scene.atmosphere) : "") +
         list("lights", lights_json(scene, path)) + list("shapes", shapes_json(scene, path)) +
         (has_instances ? list("instances", instances_json(scene)) : "") + "\n}\n";
}

WrittenScene written_exchange(const SceneToWrite& input, const std::string& path) {
  const Scene& scene = input.scene;
  WrittenScene written;
  for (std::size_t i = 0; i < scene.geometry->shapes().size(); ++i)
    if (const Mesh* mesh = scene.geometry->mesh(std::uint32_t(i)))
      written.files.push_back({exchange_mesh_file(path, i),
                               [mesh](const std::string& file) { write_file(file, ply_bytes(*mesh)); }});
  for (std::size_t i = 0; i < scene.lights.size(); ++i)
    if (const Image* picture = picture_of(scene.lights[i]))
      written.files.push_back(
          {exchange_light_file(path, i), [picture](const std::string& file) { write_exr(file, *picture); }});
  const std::vector<std::size_t> first = first_of_picture(scene);
  for (std::size_t i = 0; i < scene.textures.size(); ++i)
    if (const MipMap* picture = picture_of(scene.textures[i]); picture && first[i] == i)
      written.files.push_back({exchange_texture_file(path, i),
                               [picture](const std::string& file) { write_exr(file, picture->image(0)); }});
  for (std::size_t i = 0; i < scene.densities.size(); ++i)
    written.files.push_back(
        {exchange_density_file(path, i),
         [grid = scene.densities[i]](const std::string& file) { write_exr(file, density_picture(*grid)); }});
  const std::vector<std::size_t> first_material = first_of_brdf(scene);
  for (std::size_t i = 0; i < scene.materials.size(); ++i)
    if (const MeasuredBrdf* brdf = brdf_of(scene.materials[i]); brdf && first_material[i] == i)
      written.files.push_back({exchange_brdf_file(path, i), [brdf](const std::string& file) {
                                 write_file(file, brdf_file_bytes(*brdf, BrdfColors::rgb));
                               }});
  const RenderDefaults& asked = input.picture;
  const ExchangePicture picture{asked.resolution->width,
                                asked.resolution->height,
                                asked.samples,
                                asked.max_depth,
                                asked.filter,
                                asked.crop,
                                asked.daylight_kelvin};
  written.files.push_back({path, [&scene, path, picture](const std::string& file) {
                             write_file(file, exchange_json(scene, path, picture));
                           }});
  return written;
}

}  // namespace twinray
