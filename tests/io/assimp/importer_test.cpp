// SPDX-License-Identifier: Apache-2.0
// Scenes that Assimp reads, and the process of its own that it does so in.
#include <fmt/format.h>

#include <csignal>

#include "core/textured_material.h"
#include "io/assimp/apart.h"
#include "io/assimp/model_bytes.h"
#include "io/picture/image_file.h"
#include "io/scene_file.h"
#include "tests/support/catch.h"
#include "tests/support/sanitizer.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {
namespace {

/// A square of a red material with a picture, moved, and a mirrored copy of it.
const std::string squares =
    "AC3Db\n"
    "MATERIAL \"red\" rgb 1 0 0  amb 0 0 0  emis 0 0 0  spec 0 0 0  shi 0  trans 0\n"
    "OBJECT world\nkids 2\n"
    "OBJECT poly\nname \"left\"\nloc 5 0 0\ntexture \"wood.png\"\nnumvert 4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
    "numsurf 1\nSURF 0x20\nmat 0\nrefs 4\n0 0 0\n1 1 0\n2 1 1\n3 0 1\nkids 0\n"
    "OBJECT poly\nname \"right\"\nrot -1 0 0  0 1 0  0 0 1\nnumvert 3\n0 0 0\n1 0 0\n0 1 0\n"
    "numsurf 1\nSURF 0x20\nmat 0\nrefs 3\n0 0 0\n1 0 0\n2 0 0\nkids 0\n";

/// A triangle of a red material whose color is a picture's.
const std::string painted = R"(FBXHeaderExtension: {
 FBXVersion: 7300
}
Objects: {
 Geometry: 1, "Geometry::quad", "Mesh" {
  Vertices: *9 { a: 0,0,0,1,0,0,0,1,0 }
  PolygonVertexIndex: *3 { a: 0,1,-3 }
  LayerElementUV: 0 {
   MappingInformationType: "ByPolygonVertex"
   ReferenceInformationType: "Direct"
   UV: *6 { a: 0,0,1,0,0,1 }
  }
  LayerElementMaterial: 0 {
   MappingInformationType: "AllSame"
   ReferenceInformationType: "IndexToDirect"
   Materials: *1 { a: 0 }
  }
  Layer: 0 {
   LayerElement: {
    Type: "LayerElementMaterial"
    TypedIndex: 0
   }
   LayerElement: {
    Type: "LayerElementUV"
    TypedIndex: 0
   }
  }
 }
 Model: 2, "Model::quad", "Mesh" {
 }
 Material: 3, "Material::m", "" {
  ShadingModel: "lambert"
  Properties70: {
   P: "DiffuseColor", "Color", "", "A",1,0,0
  }
 }
 Texture: 4, "Texture::t", "" {
  RelativeFilename: "wood.png"
 }
}
Connections: {
 C: "OO",2,0
 C: "OO",1,2
 C: "OO",3,2
 C: "OP",4,3, "DiffuseColor"
}
)";

/// A triangle in FBX, with more objects and connections.
std::string fbx_triangle(const std::string& objects, const std::string& connections) {
  return R"(FBXHeaderExtension: {
 FBXVersion: 7300
}
Objects: {
 Geometry: 1, "Geometry::quad", "Mesh" {
  Vertices: *9 { a: 0,0,0,1,0,0,0,1,0 }
  PolygonVertexIndex: *3 { a: 0,1,-3 }
 }
 Model: 2, "Model::m", "Mesh" {
 }
)" + objects +
         "}\nConnections: {\n C: \"OO\",2,0\n C: \"OO\",1,2\n" + connections + "}\n";
}

const std::string identity = "*16 { a: 1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1 }\n";
const std::string skinned = fbx_triangle(
    " Model: 8, \"Model::bone\", \"LimbNode\" {\n }\n Deformer: 6, \"Deformer::s\", \"Skin\" {\n }\n"
    " Deformer: 7, \"SubDeformer::c\", \"Cluster\" {\n Indexes: *3 { a: 0,1,2 }\n"
    " Weights: *3 { a: 1,1,1 }\n Transform: " +
        identity + " TransformLink: " + identity + " }\n",
    " C: \"OO\",8,0\n C: \"OO\",6,1\n C: \"OO\",7,6\n C: \"OO\",8,7\n");
const std::string morphed = fbx_triangle(
    " Geometry: 5, \"Geometry::s\", \"Shape\" {\n Indexes: *1 { a: 0 }\n Vertices: *3 { a: 0,0,1 }\n"
    " Normals: *3 { a: 0,0,0 }\n }\n Deformer: 6, \"Deformer::b\", \"BlendShape\" {\n }\n"
    " Deformer: 7, \"SubDeformer::c\", \"BlendShapeChannel\" {\n DeformPercent: 100\n"
    " FullWeights: *1 { a: 100 }\n }\n",
    " C: \"OO\",6,1\n C: \"OO\",7,6\n C: \"OO\",5,7\n");

std::string error_of(const std::string& path) {
  try {
    load_scene(path);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

ObjModel small_model() {
  ObjModel model;
  model.name = "a";
  model.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  model.uvs = {{0.5f, 0.25f}};
  model.faces = {
      {"object", "group", 0, false, true, {{0, no_element, 0}, {1, no_element, 0}, {2, no_element, 0}}, {3}}};
  model.materials.resize(1);
  model.materials[0].name = "red";
  model.materials[0].diffuse[0] = 1;
  model.materials[0].emissive_texname = "lamp.png";
  model.materials[0].diffuse_texopt.scale[0] = 2;
  model.material_files = {"a.fbx"};
  model.notes = {"one"};
  return model;
}

/// A triangle in a file of Stanford's triangles whose corners have colors.
const std::string colored = "COFF\n3 1 0\n0 0 0 255 0 0 255\n1 0 0 0 255 0 255\n0 1 0 0 0 255 255\n3 0 1 2\n";

}  // namespace

TEST_CASE("colors of vertices that Assimp reads are told") {
  const TemporaryFolder folder;
  write_text(folder.file("a.off"), colored);
  const std::vector<std::string> notes = load_scene(folder.file("a.off")).summary.notes;
  CHECK(std::count(notes.begin(), notes.end(), "meshes' colors of vertices of the file, left out: 1") == 1);
}

TEST_CASE("skins and morph targets that Assimp reads are told") {
  const TemporaryFolder folder;
  const auto notes = [&](const std::string& text) {
    write_text(folder.file("a.fbx"), text);
    return load_scene(folder.file("a.fbx")).summary.notes;
  };
  CHECK(notes(fbx_triangle("", "")).empty());
  CHECK(notes(skinned) == std::vector<std::string>{"meshes' skins of the file, left out: 1"});
  CHECK(notes(morphed) == std::vector<std::string>{"meshes' morph targets of the file, left out: 1"});
}

/// A painted triangle with three more pictures, 5 to 7, in a file of the folder.
LoadedScene load_painted(const TemporaryFolder& folder, const std::string& connections) {
  const auto texture = [&](int number, const std::string& name) {
    write_png(folder.file(name + ".png"), {1, 1, {200, 100, 100}});
    return fmt::format(" Texture: {}, \"Texture::{}\", \"\" {{\n  RelativeFilename: \"{}.png\"\n }}\n",
                       number, name, name);
  };
  write_png(folder.file("wood.png"), {1, 1, {200, 100, 100}});
  std::string text = painted;
  text.insert(text.find("}\nConnections"), texture(5, "metal") + texture(6, "rough") + texture(7, "gloss"));
  text.insert(text.rfind("}\n"), connections);
  write_text(folder.file("a.fbx"), text);
  return load_scene(folder.file("a.fbx"));
}

TEST_CASE("the normal map of an imported scene leans as its picture says") {
  const TemporaryFolder folder;
  const LoadedScene loaded = load_painted(folder, " C: \"OP\",5,3, \"NormalMap\"\n");
  const std::uint32_t map = loaded.scene.materials.at(0).normal_map;
  REQUIRE(map != no_texture);
  CHECK(loaded.scene.textures[map].name == "metal.png");
  CHECK(std::holds_alternative<ImageTexture>(loaded.scene.textures[map].model));
}

TEST_CASE("metalness and roughness of FBX may be pictures, as the color, and other pictures are told") {
  const TemporaryFolder folder;
  const auto load = [&](const std::string& connections) { return load_painted(folder, connections); };
  CHECK(load("").summary.notes.empty());
  for (const auto& [metalness, roughness] :
       {std::pair{"Maya|metalness", "Maya|diffuseRoughness"},
        std::pair{"Maya|TEX_metallic_map", "Maya|TEX_roughness_map"},
        std::pair{"3dsMax|Parameters|metalness_map", "3dsMax|Parameters|roughness_map"}}) {
    CAPTURE(metalness);
    const LoadedScene loaded =
        load(fmt::format(" C: \"OP\",5,3, \"{}\"\n C: \"OP\",6,3, \"{}\"\n", metalness, roughness));
    CHECK(loaded.warnings.empty());
    CHECK(loaded.summary.notes.empty());
    const Material& material = loaded.scene.materials.at(0);
    const auto picture = [&](MaterialInput input) {
      const TextureUse* const use = texture_use(material, input);
      return use ? loaded.scene.textures[use->texture].name : "none";
    };
    CHECK(picture(MaterialInput::reflectance) == "wood.png");
    CHECK(picture(MaterialInput::base_metalness) == "metal.png");
    CHECK(picture(MaterialInput::roughness) == "rough.png");
  }
  CHECK(load(" C: \"OP\",7,3, \"ShininessExponent\"\n").summary.notes ==
        std::vector<std::string>{"pictures of gloss of the file, left out: 1"});
}

TEST_CASE("pictures of an imported scene are placed as it says") {
  const TemporaryFolder folder;
  write_png(folder.file("wood.png"), {1, 1, {200, 200, 200}});
  const auto reach = [&](const std::string& placed) {
    std::string text = squares;
    text.insert(text.find("texture \"wood.png\"\n") + 19, placed);
    write_text(folder.file("a.ac"), text);
    float most = 0;
    const LoadedScene loaded = load_scene(folder.file("a.ac"));
    for (const Shape& shape : loaded.scene.geometry->shapes())
      for (const Vec2& uv : std::get<Mesh>(shape).uvs) most = std::max({most, uv.x, uv.y});
    return most;
  };
  CHECK(reach("texrep 4 4\n") > reach("") + 0.5f);
}

TEST_CASE("nodes, materials and pictures of an imported scene are where the file has them") {
  const TemporaryFolder folder;
  write_png(folder.file("wood.png"), {1, 1, {200, 200, 200}});
  write_text(folder.file("a.ac"), squares);
  const LoadedScene loaded = load_scene(folder.file("a.ac"));
  CHECK(loaded.warnings.empty());
  const Scene& scene = loaded.scene;
  REQUIRE(scene.geometry->shapes().size() == 2);
  const Mesh &left = *scene.geometry->mesh(0), &right = *scene.geometry->mesh(1);
  CHECK(scene.geometry->bounds().upper.x == 6);
  CHECK(scene.geometry->bounds().lower.x == -1);
  CHECK(left.triangles.size() == 2);
  CHECK(left.uvs.size() == 4);
  // Mirrored, the front stays the front.
  const Vec3 &a = right.positions[right.triangles[0][0]], &b = right.positions[right.triangles[0][1]],
             &c = right.positions[right.triangles[0][2]];
  CHECK(cross(b - a, c - a).z > 0);
  const Material& red = scene.materials[scene.bindings[0].material];
  CHECK(std::get<Lambert>(red.model).reflectance == Rgb{1, 0, 0});
  REQUIRE(red.textures.size() == 1);
  const auto& product = std::get<ScaleTexture>(scene.textures[red.textures[0].texture].model);
  const auto& picture = std::get<ImageTexture>(scene.textures[product.first].model);
  CHECK(picture.uv({0.25f, 0.75f}) == Vec2{0.25f, 0.75f});
  CHECK(std::get<ConstantTexture>(scene.textures[product.second].model).value == Rgb{1, 0, 0});
}

TEST_CASE("a picture takes the color's place in FBX, whatever the letters of the file's name") {
  const TemporaryFolder folder;
  write_png(folder.file("wood.png"), {1, 1, {255, 255, 255}});
  for (const std::string name : {"a.fbx", "a.FBX"}) {
    write_text(folder.file(name), painted);
    const LoadedScene loaded = load_scene(folder.file(name));
    const Material& material = loaded.scene.materials[loaded.scene.bindings[0].material];
    REQUIRE(material.textures.size() == 1);
    CHECK(evaluate(loaded.scene.textures, material.textures[0].texture, {{0.5f, 0.5f}}) == white);
  }
}

TEST_CASE("a file that Assimp does not understand is an error with its name") {
  const TemporaryFolder folder;
  const auto refuses = [&](const std::string& name, const std::string& text, const std::string& said) {
    const std::string path = folder.file(name);
    write_text(path, text);
    CAPTURE(name, error_of(path));
    CHECK(error_of(path).starts_with(path + ": "));
    CHECK(error_of(path).find(said) != std::string::npos);
  };
  refuses("a.off", "", "the file is empty");
  refuses("b.fbx", "nothing of the kind", "");
  refuses("c.ac", "AC3Db\nOBJECT world\nkids 0\n", "");
  refuses("d.off", "OFF\n353535235358 6 0\n0 0 0\n",
          has_sanitizer ? "" : "it would take more memory than its size allows");
  refuses("e.ac",
          "AC3Db\nMATERIAL \"\" rgb 1 1 1  amb 0 0 0  emis 0 0 0  spec 0 0 0  shi 0  trans 0\nOBJECT world\n"
          "kids 1\nOBJECT poly\nnumvert 3\n0 0 0\n1e30 0 0\n0 1 0\nnumsurf 1\nSURF 0x20\nmat 0\nrefs 3\n"
          "0 0 0\n1 0 0\n2 0 0\nkids 0\n",
          "lies beyond +-1e+12");
}

TEST_CASE("work that runs apart gives its bytes or its fault, however it ends") {
  const std::string many(3000000, 'x');
  CHECK(run_apart(1 << 30, [&] { return many; }).bytes == many);
  CHECK(run_apart(1 << 30, []() -> std::string { throw Error("no good"); }).fault == "no good");
  CHECK(run_apart(1 << 30, []() -> std::string { throw Error(""); }).fault ==
        "it cannot be read, and the library does not say why");
  CHECK(run_apart(1 << 30, []() -> std::string {
          std::raise(SIGSEGV);
          return "";
        }).fault == "what reads it was ended by signal 11");
  if (!has_sanitizer)
    CHECK(run_apart(1 << 26, [] { return std::string(std::size_t(1) << 28, 'x'); }).fault.find("memory") !=
          std::string::npos);
  int here = 0;
  CHECK(run_apart(1 << 30, [&] {
          ++here;
          return std::string("done");
        }).bytes == "done");
  CHECK(here == 0);  // It ran in another process.
}

TEST_CASE("a model comes back from its bytes, and from no others") {
  const ObjModel model = small_model();
  const std::string bytes = model_bytes(model);
  const ObjModel back = model_of_bytes(bytes);
  CHECK(model_bytes(back) == bytes);
  CHECK(back.faces[0].group == "group");
  CHECK(back.materials[0].emissive_texname == "lamp.png");
  CHECK(back.materials[0].diffuse_texopt.scale[0] == 2);
  CHECK(back.material_files == model.material_files);
  for (std::size_t size = 0; size < bytes.size(); ++size)
    CHECK_THROWS_AS(model_of_bytes(bytes.substr(0, size)), Error);
  CHECK_THROWS_AS(model_of_bytes(bytes + "x"), Error);
  for (const auto damage :
       {+[](ObjModel& m) { m.faces[0].corners[1].position = 3; },
        +[](ObjModel& m) { m.faces[0].corners[2].uv = 1; },
        +[](ObjModel& m) { m.faces[0].has_normals = true; }, +[](ObjModel& m) { m.faces[0].sizes[0] = 4; },
        +[](ObjModel& m) { m.faces[0].material = 1; }, +[](ObjModel& m) { m.material_files.clear(); }}) {
    ObjModel damaged = small_model();
    damage(damaged);
    CHECK_THROWS_AS(model_of_bytes(model_bytes(damaged)), Error);
  }
}

}  // namespace twinray::test
