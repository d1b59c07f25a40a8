// SPDX-License-Identifier: Apache-2.0
// Objects of extensions in glTF files: those that nobody reads, and those that stand where they mean nothing.
#include "tests/io/gltf/file.h"
#include "tests/support/catch.h"

namespace twinray {
namespace {

using nlohmann::json;
using test::gltf_surface;
using test::gltf_triangle;
using test::GltfFile;

}  // namespace

TEST_CASE("gltf: an extension that is not read is named where it stands, unless it is declared") {
  GltfFile file = gltf_triangle();
  json& extensions = file.json["nodes"][0]["extensions"];
  extensions["KHR_light_punctual"] = {{"light", 7}};
  CHECK(
      file.warning() ==
      "test.gltf: /nodes/0/extensions/KHR_light_punctual: the extension KHR_light_punctual is not rendered; "
      "did you mean KHR_lights_punctual?");
  LoadOptions strict;
  strict.strict = true;
  CHECK(file.error(strict) == file.warning());
  file.json["extensionsUsed"] = {"KHR_light_punctual"};
  CHECK(file.warning() ==
        "test.gltf: /extensionsUsed/0: the extension KHR_light_punctual is not rendered; did you mean "
        "KHR_lights_punctual?");
  file = gltf_triangle();
  file.json["nodes"][0]["extensions"]["A/B"] = 3;
  CHECK(file.warning() == "test.gltf: /nodes/0/extensions/A~1B: the extension A/B is not rendered");
}

TEST_CASE("gltf: an extension that changes no picture needs no declaration") {
  GltfFile file = gltf_triangle();
  file.json["extensions"]["KHR_xmp_json_ld"] = {{"packets", json::array()}};
  file.json["nodes"][0]["extensions"]["MSFT_lod"] = {{"ids", {0}}};
  CHECK(file.load().warnings.empty());
}

TEST_CASE("gltf: a long beginning or end that names of extensions share is no likeness") {
  const auto warning = [](const char* name) {
    GltfFile file = gltf_triangle();
    file.json["extensionsUsed"] = {name};
    const std::string text = file.warning();
    const std::size_t at = text.find("; did you mean ");
    return at == std::string::npos ? "" : text.substr(at + 15);
  };
  for (const char* other :
       {"KHR_materials_dispersion", "KHR_materials_diffuse_transmission", "KHR_materials_volume_scatter",
        "EXT_texture_avif", "KHR_texture_basisu", "KHR_meshopt_compression", "EXT_foo_compression",
        "ADOBE_materials_clearcoat_specular"})
    CHECK(warning(other) == "");
  CHECK(warning("KHR_materials_unlt") == "KHR_materials_unlit?");
  CHECK(warning("KHR_materials_unli") == "KHR_materials_unlit?");
  CHECK(warning("KHR_materials_transmision") == "KHR_materials_transmission?");
  CHECK(warning("EXT_meshopt_compresion") == "EXT_meshopt_compression?");
  CHECK(warning("KHR_material_unlit") == "KHR_materials_unlit?");
  CHECK(warning("khr_materials_unlit") == "KHR_materials_unlit?");
  CHECK(warning("KRH_texture_transfrom") == "KHR_texture_transform?");
}

TEST_CASE("gltf: an extension where it means nothing is named, and its values are not read") {
  struct Fault {
    const char *place, *name, *owner;
  };
  const Fault faults[] = {
      {"/materials/0/pbrMetallicRoughness", "KHR_materials_unlit", "a material"},
      {"/nodes/0", "KHR_materials_unlit", "a material"},
      {"", "KHR_materials_unlit", "a material"},
      {"/textures/0", "KHR_texture_transform", "what names a texture, such as \"baseColorTexture\""},
      {"/scenes/0", "KHR_lights_punctual", "the file as a whole, and to a node"},
      {"/materials/0", "KHR_draco_mesh_compression", "a primitive of a mesh"},
      {"/meshes/0", "KHR_node_visibility", "a node"},
      {"/accessors/0", "EXT_meshopt_compression", "a buffer view, and to a buffer"},
      {"/materials/0", "EXT_texture_webp", "a texture"},
      {"/meshes/0/primitives/0", "EXT_mesh_gpu_instancing", "a node"},
      {"/meshes/0/primitives/0", "KHR_mesh_quantization", "\"extensionsUsed\" alone"},
      {"/materials/0/extensions/KHR_materials_clearcoat", "KHR_materials_ior", "a material"},
  };
  for (const Fault& fault : faults) {
    INFO(fault.place << " " << fault.name);
    GltfFile file = gltf_surface({{"pbrMetallicRoughness", json::object()},
                                  {"extensions", {{"KHR_materials_clearcoat", json::object()}}}});
    file.json["textures"] = json::array({json::object()});
    const std::string place = std::string(fault.place) + "/extensions/" + fault.name;
    file.json[json::json_pointer(place)] = "no object";
    CHECK(file.warning() ==
          "test.gltf: " + place + ": " + fault.name + " has no effect here: it belongs to " + fault.owner);
  }
}

TEST_CASE("gltf: an extension that an unlit surface excludes is named, and has no effect") {
  const json none = json::object();
  for (const char* name :
       {"KHR_materials_anisotropy", "KHR_materials_clearcoat", "KHR_materials_emissive_strength",
        "KHR_materials_ior", "KHR_materials_iridescence", "KHR_materials_sheen", "KHR_materials_specular",
        "KHR_materials_transmission", "KHR_materials_volume"}) {
    const GltfFile file = gltf_surface({{"extensions", {{"KHR_materials_unlit", none}, {name, none}}}});
    CHECK(file.warning() == "test.gltf: /materials/0/extensions/" + std::string(name) + ": " + name +
                                " has no effect beside KHR_materials_unlit");
  }
  const GltfFile alone = gltf_surface({{"extensions", {{"KHR_materials_unlit", none}}}});
  CHECK(alone.load().warnings.empty());
}

TEST_CASE("gltf: an unlit surface of specular and glossiness shows its diffuse color") {
  const GltfFile file =
      gltf_surface({{"extensions",
                     {{"KHR_materials_unlit", json::object()},
                      {"KHR_materials_pbrSpecularGlossiness", {{"diffuseFactor", {0.5, 0.25, 1, 1}}}}}}});
  CHECK(file.warning() ==
        "test.gltf: /materials/0/extensions/KHR_materials_pbrSpecularGlossiness: beside KHR_materials_unlit "
        "its "
        "diffuse color alone counts");
  const LoadedScene loaded = file.load();
  CHECK(std::get<MeshLight>(loaded.scene.lights.at(0).source).radiance == Rgb{0.5f, 0.25f, 1});
}

TEST_CASE("gltf: beside specular and glossiness nothing else says what is reflected") {
  const json glossy = {{"specularFactor", {0.25, 0.125, 0}}};
  const auto with = [&](const char* name, const json& value) {
    return gltf_surface({{"extensions", {{"KHR_materials_pbrSpecularGlossiness", glossy}, {name, value}}}});
  };
  const std::string place = "test.gltf: /materials/0/extensions/";
  const GltfFile specular = with("KHR_materials_specular", {{"specularColorFactor", {0, 0, 1}}});
  CHECK(specular.warning() == place +
                                  "KHR_materials_specular: KHR_materials_specular has no effect beside "
                                  "KHR_materials_pbrSpecularGlossiness, which says what is reflected");
  CHECK(std::get<Principled>(specular.load().scene.materials[0].model).specular_color == Rgb{1, 0.5f, 0});
  CHECK(with("KHR_materials_ior", {{"ior", 2}}).warning() ==
        place +
            "KHR_materials_ior: KHR_materials_ior has no effect beside "
            "KHR_materials_pbrSpecularGlossiness, which says what is reflected");
  CHECK(with("KHR_materials_sheen", json::object()).warning() ==
        place +
            "KHR_materials_sheen: the format excludes KHR_materials_sheen beside "
            "KHR_materials_pbrSpecularGlossiness; both are rendered");
  CHECK(with("KHR_materials_emissive_strength", json::object()).load().warnings.empty());
}

}  // namespace twinray
