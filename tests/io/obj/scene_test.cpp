// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "io/picture/image_file.h"
#include "io/scene_file.h"
#include "tests/support/catch.h"
#include "tests/support/obj_text.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {
namespace {

/// The material of a triangle that has one with these lines.
struct Made {
  LoadedScene loaded;
  const Material& material() const { return loaded.scene.materials[binding().material]; }
  const ShapeBinding& binding() const { return loaded.scene.bindings[0]; }
  template <typename Model>
  const Model& model() const {
    return std::get<Model>(material().model);
  }
  const Texture& texture(std::uint32_t index) const { return loaded.scene.textures[index]; }
};

Made made_of(const std::string& lines) {
  return {load_obj_text("mtllib a.mtl\nvt 0 0\n" + obj_square + "usemtl m\nf 1/1 2/1 3/1\n",
                        {{"a.mtl", "newmtl m\n" + lines}})};
}

}  // namespace

TEST_CASE("faces of an OBJ file become triangles with their winding, normals and texture coordinates") {
  const LoadedScene loaded = load_obj_text(
      obj_square + "vn 0 0 2\nvt 0 0\nvt 1 0\nvt 1 1\nf 1/1/1 2/2/1 3/3/1\nf -4/-3/-1 -2/-1/-1 -1/-2/-1\n");
  const Mesh& mesh = mesh_of(loaded);
  CHECK(mesh.triangles == std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}});
  CHECK(mesh.positions[3] == Vec3{0, 1, 0});
  CHECK(mesh.uv_indices == std::vector<Triangle>{{0, 1, 2}, {0, 2, 1}});
  CHECK(mesh.uvs[2] == Vec2{1, 1});
  CHECK(mesh.normals == std::vector<Vec3>{{0, 0, 1}});
  CHECK(loaded.warnings.empty());
  CHECK(loaded.wants_light);
  CHECK(std::holds_alternative<Lambert>(loaded.scene.materials[0].model));
}

TEST_CASE("a face of an OBJ file may have many corners, be concave, and stand before its vertices") {
  const std::string arrow = "f 1 2 3 4\nv 0 0 0\nv 2 1 0\nv 0 2 0\nv 1 1 0\n";
  const LoadedScene loaded = load_obj_text(arrow);
  const Mesh& mesh = mesh_of(loaded);
  CHECK(mesh.triangles.size() == 2);
  for (const Triangle& triangle : mesh.triangles)  // None lies outside, across the notch.
    CHECK(std::count(triangle.begin(), triangle.end(), 3u) == 1);
  std::string round = "";
  std::string face = "f";
  for (int i = 0; i < 300; ++i) {
    round += fmt::format("v {} {} 0\n", i, (i - 150) * (i - 150));
    face += fmt::format(" {}", i + 1);
  }
  CHECK(load_obj_text(round + face).scene.geometry->triangle_count() == 298);
}

TEST_CASE("objects, groups and materials of an OBJ file are shapes of their own") {
  const LoadedScene loaded = load_obj_text("mtllib a.mtl\n" + obj_square +
                                               "f 1 2 3\no car\nusemtl red\nf 1 2 4\ng wheel\nf 2 3 "
                                               "4\nusemtl blue\nf 2 3 4\nusemtl red\nf 1 3 4\r\n",
                                           {{"a.mtl", "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n"}});
  REQUIRE(loaded.scene.bindings.size() == 4);
  CHECK(loaded.scene.bindings[0].asset == no_asset);
  CHECK(loaded.scene.assets == std::vector<std::string>{"car"});
  CHECK(loaded.scene.bindings[3].asset == 0);
  CHECK(mesh_of(loaded, 1).name == "car");
  CHECK(mesh_of(loaded, 2).name == "wheel");
  CHECK(mesh_of(loaded, 2).triangles.size() == 2);
  const auto red = [&](std::uint32_t shape) {
    return std::get<Lambert>(loaded.scene.materials[loaded.scene.bindings[shape].material].model)
        .reflectance.r;
  };
  CHECK(red(1) == 1);
  CHECK(red(2) == 1);
  CHECK(red(3) == 0);
}

TEST_CASE("a group ends where another object begins") {
  const LoadedScene loaded = load_obj_text(obj_square + "o car\ng wheel\nf 1 2 3\no house\nf 2 3 4\n");
  CHECK(mesh_of(loaded, 0).name == "wheel");
  CHECK(mesh_of(loaded, 1).name == "house");
}

TEST_CASE("a group ends where a line has g alone") {
  for (const std::string end : {"g\n", "g \t\r\n", "g\r\n", "g \n"}) {
    const LoadedScene loaded =
        load_obj_text(obj_square + "g wheel\nf 1 2 3\n" + end + "f 2 3 4\ng door\nf 1 2 3\n" + end +
                      "g roof\nf 1 2 3\n" + end + end + "f 1 3 4\n");
    REQUIRE(loaded.scene.geometry->shapes().size() == 4);
    CHECK(mesh_of(loaded, 0).name == "wheel");
    CHECK(mesh_of(loaded, 1).name == "scene");
    CHECK(mesh_of(loaded, 1).triangles.size() == 2);
    CHECK(mesh_of(loaded, 2).name == "door");
    CHECK(mesh_of(loaded, 3).name == "roof");
  }
}

TEST_CASE("what an OBJ file has beside faces is told") {
  const LoadedScene loaded =
      load_obj_text("v 0 0 0 0.5\n" + obj_square + "vn 0 0 0\nf 2 3\nf 2//1 3//1 4//1\n");
  const std::vector<std::string> notes{
      "3 shading normals have no direction; those of their triangles stand for them",
      "faces of less than three corners, left out: 1",
      "weights of vertices, behind their coordinates, are left out"};
  CHECK(loaded.summary.notes == notes);
  CHECK(mesh_of(loaded).normals.back() == Vec3{0, 0, 1});
}

TEST_CASE("a material that an OBJ file lacks is grey, with a warning") {
  const LoadedScene absent = load_obj_text("mtllib no.mtl\n" + obj_square + "usemtl red\nf 1 2 3\n");
  REQUIRE(absent.warnings.size() == 2);
  CHECK(absent.warnings[0].text() ==
        "scene.obj:1:1: its materials are grey: no.mtl: there is no such file\n  mtllib no.mtl\n  ^");
  CHECK(absent.warnings[1].message == "there is no material \"red\"; it is grey");
  CHECK_THROWS_AS(load_obj_text("mtllib no.mtl\n" + obj_square + "f 1 2 3\n", {}, true), Error);
}

TEST_CASE("names of materials and their files may have spaces") {
  const TemporaryFolder folder;
  write_text(folder.file("my colors.mtl"), "newmtl deep red \nKd 1 0 0\n");
  write_text(folder.file("a.obj"), "mtllib my colors.mtl \n" + obj_square + "usemtl  deep red\nf 1 2 3\n");
  LoadOptions options;
  options.files = std::make_shared<std::vector<std::string>>();
  const LoadedScene loaded = load_scene(folder.file("a.obj"), options);
  CHECK(loaded.warnings.empty());
  CHECK(loaded.scene.materials[0].name == "deep red");
  CHECK(*options.files == std::vector<std::string>{folder.file("a.obj"), folder.file("my colors.mtl")});
}

TEST_CASE("MTL's models of illumination become materials") {
  CHECK(made_of("Kd 0.1 0.2 2\n").model<Lambert>().reflectance == Rgb{0.1f, 0.2f, 1});
  const Made glossy = made_of("Kd 0.5 0.5 0.5\nKs 0.25 0.125 0.25\nNs 30\nillum 2\n");
  CHECK(glossy.model<Principled>().specular_weight == 0.5f);
  CHECK(glossy.model<Principled>().specular_color == Rgb{1, 0.5f, 1});
  CHECK(glossy.model<Principled>().specular_roughness == 0.5f);  // The fourth root of 2 / (Ns + 2).
  CHECK(std::holds_alternative<Lambert>(made_of("Kd 1 1 1\nKs 1 1 1\nillum 1\n").material().model));
  CHECK(made_of("Kd 0 0 0\nKs 0.9 0.9 0.9\nillum 3\n").model<Mirror>().reflectance == Rgb{0.9f, 0.9f, 0.9f});
  const Made glass = made_of("illum 7\nNi 1.4\nTf 0.5 1 1\nd 0.2\n");
  CHECK(glass.model<Dielectric>().ior == 1.4f);
  CHECK(glass.model<Dielectric>().transmittance == Rgb{0.5f, 1, 1});
  CHECK(glass.binding().alpha == no_texture);
}

TEST_CASE("MTL's values for physically based rendering are those of the principled material") {
  const Made pbr = made_of("Kd 1 0 0\nPr .25\nPm .5\nPs .125\nPc .75\nPcr .0625\naniso .5\nNi 1.25");
  const Principled& model = pbr.model<Principled>();
  CHECK(model.base_color == Rgb{1, 0, 0});
  CHECK(model.specular_roughness == 0.25f);
  CHECK(model.base_metalness == 0.5f);
  CHECK(model.fuzz_weight == 0.125f);
  CHECK(std::pair(model.coat_weight, model.coat_roughness) == std::pair(0.75f, 0.0625f));
  CHECK(model.specular_roughness_anisotropy == 0.5f);
  CHECK(model.specular_ior == 1.25f);
}

TEST_CASE("surfaces of an OBJ file emit, and are dissolved, as MTL says") {
  const Made lamp = made_of("Ke 1 2 3\n");
  REQUIRE(lamp.loaded.scene.lights.size() == 1);
  CHECK(std::get<MeshLight>(lamp.loaded.scene.lights[0].source).radiance == Rgb{1, 2, 3});
  CHECK(!lamp.loaded.wants_light);
  const Made thin = made_of("d 0.25\n");
  CHECK(std::get<ConstantTexture>(thin.loaded.scene.textures.at(thin.binding().alpha).model).value.r == .25f);
  CHECK(!thin.loaded.scene.geometry->is_opaque(0));
  const Made cut = made_of("d 0.5\nmap_d leaf.png\n");
  CHECK(std::holds_alternative<ScaleTexture>(cut.texture(cut.binding().alpha).model));
  const Made shown = made_of("map_Ke lamp.png\n");
  CHECK(std::get<MeshLight>(shown.loaded.scene.lights[0].source).picture);
}

TEST_CASE("pictures of MTL files are textures, placed as their options say") {
  const Made made =
      made_of("Kd 1 1 1\nPr 1\nmap_Kd -s 2 3 1 -o 0.5 0.25 0 -clamp on a.png\nmap_Pm b.png\nmap_Pr c.png\n");
  REQUIRE(made.material().textures.size() == 3);
  CHECK(made.material().textures[0].input == MaterialInput::reflectance);
  CHECK(made.material().textures[1].input == MaterialInput::roughness);
  CHECK(made.material().textures[2].input == MaterialInput::base_metalness);
  const auto& picture = std::get<ImageTexture>(made.texture(made.material().textures[0].texture).model);
  CHECK(picture.uv({1, 1}).x == 2.5f);
  CHECK(picture.uv({1, 1}).y == 3.25f);
  CHECK(picture.wrap == WrapMode::clamp);
  CHECK(made_of("norm n.png\n").material().normal_map != no_texture);
  CHECK(made_of("bump -bm 0.5 h.png\n").material().bump_map != no_texture);
  const Made rest = made_of("Kd 1 1 1\nmap_Ns a.png\ndisp b.png\nrefl c.png\n");
  CHECK(rest.loaded.warnings.size() == 3);
}

TEST_CASE("a picture of what a material reflects is times its colour, unless that is black or absent") {
  const auto of_picture = [](const std::string& lines) {
    const Made made = made_of(lines);
    const std::uint32_t index = made.material().textures.at(0).texture;
    const auto* scale = std::get_if<ScaleTexture>(&made.texture(index).model);
    if (!scale) return white;
    CHECK(std::holds_alternative<ImageTexture>(made.texture(scale->first).model));
    return std::get<ConstantTexture>(made.texture(scale->second).model).value;
  };
  CHECK(of_picture("Kd 0.5 0.25 0.75\nmap_Kd a.png\n") == Rgb{0.5f, 0.25f, 0.75f});
  CHECK(of_picture("map_Kd a.png\nKd 0.5 0.25 2\nPr 0.5\n") == Rgb{0.5f, 0.25f, 1});
  for (const char* said_by_picture : {"", "Kd 0 0 0\n", "Kd 1 1 1\n"})
    CHECK(of_picture(std::string(said_by_picture) + "map_Kd a.png\n") == white);
}

TEST_CASE("what MTL lets a file leave out of a color or an option is filled in") {
  CHECK(made_of("Kd 0.25\n").model<Lambert>().reflectance == Rgb{0.25f, 0.25f, 0.25f});
  const auto picture_of = [](const std::string& line) {
    const Made made = made_of(line);
    CHECK(made.loaded.warnings.empty());
    return made.texture(made.material().textures.at(0).texture);
  };
  const auto placed = [&](const std::string& options) {
    const Texture texture = picture_of("map_Kd " + options + " my a.png\n");
    CHECK(texture.name == "my a.png");
    return std::get<ImageTexture>(texture.model).uv({1, 1});
  };
  CHECK(placed("-s 2") == Vec2{2, 1});
  CHECK(placed("-cc off -o 0.5 0.25 -blendu off -s 2 3") == Vec2{2.5f, 3.25f});
  CHECK(placed("-mm 0 1 -texres 64") == Vec2{1, 1});
  CHECK(made_of("d -halo 0.5\n").binding().alpha != no_texture);
  const Made half = made_of("d -halo 0.5\n");
  CHECK(std::get<ConstantTexture>(half.texture(half.binding().alpha).model).value.r == 0.5f);
}

TEST_CASE("a number of MTL that is missing or none is 0, with a warning at its line") {
  for (const char* line : {"Kd 0,9 1 1\n", "Kd 1 1\n", "Kd nan 1 1\n", "Ni\nKd 1 1 1\n"}) {
    CAPTURE(line);
    const Made made = made_of(line);
    REQUIRE(made.loaded.warnings.size() == 1);
    CHECK(made.loaded.warnings[0].text().starts_with("a.mtl:2:1: a number of \"" + std::string(line, 2) +
                                                     "\" is missing or none: 0 stands for it\n  "));
  }
  CHECK(made_of("Kd 0,9 1 1\n").model<Lambert>().reflectance == Rgb{0, 1, 1});
  CHECK(made_of("Kd 1 1 1 # as paper\n").loaded.warnings.empty());
}

TEST_CASE("a picture is brightened as its option says") {
  const TemporaryFolder folder;
  Image grey(1, 1, {0.5f, 0.25f, 0});
  write_exr(folder.file("grey.exr"), grey);
  write_text(folder.file("a.obj"), "mtllib a.mtl\nvt 0 0\n" + obj_square + "usemtl m\nf 1/1 2/1 3/1\n");
  write_text(folder.file("a.mtl"), "newmtl m\nmap_Kd -mm 0.25 0.5 grey.exr\nmap_Ke -mm 1 2 grey.exr\n");
  const LoadedScene loaded = load_scene(folder.file("a.obj"));
  CHECK(loaded.warnings.empty());
  const Scene& scene = loaded.scene;
  CHECK(evaluate(scene.textures, scene.materials[0].textures.at(0).texture, {{0.5f, 0.5f}}) ==
        Rgb{0.5f, 0.375f, 0.25f});
  CHECK(std::get<MeshLight>(scene.lights.at(0).source).picture->pixels[0] == Rgb{2, 1.5f, 1});
}

TEST_CASE("a picture of what surfaces emit is placed as its options say") {
  const TemporaryFolder folder;
  Image halves(2, 1);
  halves.pixels = {{1, 1, 1}, {0, 0, 0}};
  write_exr(folder.file("halves.exr"), halves);
  const auto lamp = [&](const std::string& options, const std::string& more, const std::string& uvs) {
    write_text(folder.file("a.mtl"), "newmtl m\nmap_Ke " + options + " halves.exr\n" + more);
    write_text(folder.file("a.obj"),
               "mtllib a.mtl\n" + uvs + "\n" + obj_square + "usemtl m\nf 1/1 2/2 3/3 4/4\n");
    return load_scene(folder.file("a.obj"));
  };
  const auto light_of = [](const LoadedScene& loaded) {
    return std::get<MeshLight>(loaded.scene.lights.at(0).source);
  };
  const std::string once = "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1", beside = "vt 3 0\nvt 4 0\nvt 4 1\nvt 3 1";
  for (const std::string& uvs : {once, beside}) {
    CHECK(light_of(lamp("", "", uvs)).picture->pixels == halves.pixels);
    CHECK(light_of(lamp("", "", uvs)).wrap == WrapMode::repeat);
    CHECK(light_of(lamp("-o 0.5 -s 2 3", "", uvs)).uv({1, 1}) == Vec2{2.5f, 3});
    CHECK(light_of(lamp("-clamp on", "map_Kd -s 1.5 1 halves.exr\n", uvs)).wrap == WrapMode::clamp);
    CHECK(lamp("-clamp on", "map_Kd -s 1.5 1 halves.exr\n", uvs).warnings.empty());
  }
}

TEST_CASE("a normal map is placed as its options say") {
  for (const char* line : {"norm -s 2 3 n.png\n", "norm -clamp on -s 2 3 n.png\n"}) {
    const Made made = made_of(line);
    const auto& map = std::get<ImageTexture>(made.texture(made.material().normal_map).model);
    CHECK(map.uv({1, 1}) == Vec2{2, 3});
    CHECK((map.wrap == WrapMode::clamp) == (std::string(line).find("clamp") != std::string::npos));
  }
}

TEST_CASE("a line of several material files has all of them, each with pictures beside it") {
  const TemporaryFolder folder;
  for (const std::string part : {"one", "two"}) {
    std::filesystem::create_directory(folder.file(part));
    write_png(folder.file(part + "/" + part + ".png"), {1, 1, {128, 128, 128}});
    write_text(folder.file(part + "/m.mtl"), "newmtl " + part + "\nmap_Kd " + part + ".png\n");
  }
  const std::string faces = obj_square + "vt 0 0\nusemtl one\nf 1/1 2/1 3/1\nusemtl two\nf 1/1 3/1 4/1\n";
  for (const std::string lines : {"mtllib one/m.mtl two/m.mtl\n", "mtllib one/m.mtl\nmtllib two/m.mtl\n"}) {
    write_text(folder.file("a.obj"), lines + faces);
    const LoadedScene loaded = load_scene(folder.file("a.obj"));
    CHECK(loaded.warnings.empty());
    REQUIRE(loaded.scene.materials.size() == 2);
    CHECK(loaded.scene.materials[1].name == "two");
  }
  write_text(folder.file("a.obj"), "mtllib none.mtl two\\m.mtl\n" + faces);
  const LoadedScene partly = load_scene(folder.file("a.obj"));
  REQUIRE(partly.warnings.size() == 2);
  CHECK(partly.warnings[0].message.find("none.mtl: ") != std::string::npos);
  CHECK(partly.warnings[1].message == "there is no material \"one\"; it is grey");
}

TEST_CASE("a backslash continues a line, in comments it does not, and places stay right") {
  const std::string lines = "v 0 \\\r\n0 0\n# from C:\\parts\\\nv 1 \\\n 0 \\\n 0\nv 1 1 0\n";
  const LoadedScene loaded = load_obj_text(lines + "f 1 \\\n2 3 # a comment");
  CHECK(mesh_of(loaded).positions == std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}});
  CHECK(obj_error(lines + "f 1 \\\n2 -9\n").starts_with("scene.obj:8:1: there is no element -9"));
  const LoadedScene colored = load_obj_text("mtllib a.mtl\n" + obj_square + "usemtl m\nf 1 2 3\n",
                                            {{"a.mtl", "newmtl m\nKd 1 \\\n0 0\n"}});
  CHECK(std::get<Lambert>(colored.scene.materials[0].model).reflectance == Rgb{1, 0, 0});
}

TEST_CASE("a coordinate that is no number is an error at its line, of other numbers a warning") {
  for (const std::string word : {"0,9", "nan", "inf", "x", "1.0;"})
    CHECK(obj_error(obj_square + "v 0 " + word + " 0\nf 1 2 3\n")
              .starts_with("scene.obj:5:1: a coordinate that is no number: \"" + word + "\"\n"));
  CHECK(obj_error("v 0 1\n").starts_with("scene.obj:1:1: a vertex of 2 coordinates; valid are 3\n"));
  CHECK(obj_error("v 0 1 # 2\n").starts_with("scene.obj:1:1: a vertex of 2 coordinates; valid are 3\n"));
  CHECK(obj_error("v 1e99 0 0\n").starts_with("scene.obj:1:1: a coordinate lies beyond"));
  const LoadedScene loaded =
      load_obj_text(obj_square + "vn 0 0 -1.#IND\nvn 0 0 1\nvt 0.5 nan\nvt 0.25\nf 1/1/1 2/2/2 3/2/2\n");
  REQUIRE(loaded.warnings.size() == 2);
  CHECK(loaded.warnings[0].text().starts_with(
      "scene.obj:5:1: a normal that is not three numbers: those of its triangles stand for it\n"));
  CHECK(loaded.warnings[1].text().starts_with(
      "scene.obj:7:1: texture coordinates that are no numbers: 0 stands for each\n"));
  CHECK(mesh_of(loaded).normals[mesh_of(loaded).normal_indices[0][0]] == Vec3{0, 0, 1});
  CHECK(mesh_of(loaded).uvs == std::vector<Vec2>{{0.5f, 0}, {0.25f, 0}});
}

TEST_CASE("numbers of a picture are its brightness, or the channel that the file says") {
  const auto meaning_of = [](const std::string& line) {
    LoadOptions options;
    options.pictures = std::make_shared<std::vector<PictureUse>>();
    const TemporaryFolder folder;
    write_text(folder.file("a.mtl"), "newmtl m\nPr 0.5\n" + line);
    write_text(folder.file("a.obj"), "mtllib a.mtl\nvt 0 0\n" + obj_square + "usemtl m\nf 1/1 2/1 3/1\n");
    load_scene(folder.file("a.obj"), options);
    return options.pictures->back().meaning.channels;
  };
  CHECK(meaning_of("bump a.png\n") == PictureChannels::brightness);
  CHECK(meaning_of("bump -imfchan g a.png\n") == PictureChannels::green);
  CHECK(meaning_of("map_Pr a.png\n") == PictureChannels::brightness);
  CHECK(meaning_of("map_Pr -imfchan r a.png\n") == PictureChannels::red);
  CHECK(meaning_of("map_Pm -imfchan b a.png\n") == PictureChannels::blue);
  CHECK(meaning_of("map_d a.png\n") == PictureChannels::number);
  CHECK(meaning_of("map_d -imfchan l a.png\n") == PictureChannels::brightness);
}

TEST_CASE("the mark of UTF-8 is no part of an OBJ file's first line, nor of a material file's") {
  const std::string mark = "\xef\xbb\xbf";
  const LoadedScene loaded = load_obj_text(mark + obj_square + "mtllib a.mtl\nusemtl m\nf 1 2 3\n",
                                           {{"a.mtl", mark + "newmtl m\nKd 1 0 0\n"}});
  CHECK(loaded.warnings.empty());
  CHECK(mesh_of(loaded).positions[0] == Vec3{0, 0, 0});
  CHECK(std::get<Lambert>(loaded.scene.materials[0].model).reflectance == Rgb{1, 0, 0});
}

TEST_CASE("a coordinate is the float that is nearest to what the file says") {
  const LoadedScene loaded =
      load_obj_text("v 0.1 1e-3 16777217.0000001\r\nv +.5 -5. 1E+2\nv 0 0 0\nf 1 2 3\n");
  CHECK(mesh_of(loaded).positions[0] == Vec3{0.1f, 1e-3f, 16777218.0f});
  CHECK(mesh_of(loaded).positions[1] == Vec3{0.5f, -5, 100});
}

TEST_CASE("a bump map that shows directions is a normal map, and one that is absent is told") {
  const TemporaryFolder folder;
  write_png(folder.file("blue.png"), {1, 1, {128, 128, 255}});
  write_png(folder.file("grey.png"), {1, 1, {128, 128, 128}});
  for (const std::string picture : {"blue", "grey"}) {
    write_text(folder.file("a.mtl"), "newmtl m\nKd 1 1 1\nbump " + picture + ".png\n");
    write_text(folder.file("a.obj"), "mtllib a.mtl\nvt 0 0\n" + obj_square + "usemtl m\nf 1/1 2/1 3/1\n");
    const LoadedScene loaded = load_scene(folder.file("a.obj"));
    CHECK(loaded.warnings.empty());
    CHECK((loaded.scene.materials[0].normal_map != no_texture) == (picture == "blue"));
    CHECK((loaded.scene.materials[0].bump_map != no_texture) == (picture == "grey"));
  }
  write_text(folder.file("a.mtl"), "newmtl m\nKd 1 1 1\nbump none.png\n");
  const LoadedScene flat = load_scene(folder.file("a.obj"));
  REQUIRE(flat.warnings.size() == 1);
  CHECK(flat.warnings[0].message.ends_with("; the surface stays flat"));
  write_text(folder.file("a.mtl"), "newmtl m\nmap_Kd textures\\none.png\n");
  const LoadedScene absent = load_scene(folder.file("a.obj"));
  REQUIRE(absent.warnings.size() == 1);
  CHECK(absent.warnings[0].message.find("textures/none.png") != std::string::npos);
  write_text(folder.file("a.mtl"), "newmtl m\nmap_Kd C:\\pictures\\blue.png\n");
  CHECK(load_scene(folder.file("a.obj")).warnings.empty());  // It lies beside the file.
}

TEST_CASE("a PLY file is a scene of one grey mesh") {
  const TemporaryFolder folder;
  write_text(folder.file("tri.ply"),
             "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
             "element face 2\nproperty list uchar int vertex_indices\nend_header\n"
             "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n2 0 1\n");
  const LoadedScene loaded = load_scene(folder.file("tri.ply"));
  CHECK(mesh_of(loaded).name == "tri");
  CHECK(mesh_of(loaded).triangles.size() == 1);
  CHECK(loaded.wants_light);
  CHECK(loaded.summary.notes == std::vector<std::string>{"faces of less than three corners, left out: 1"});
  CHECK(!is_scene_file(folder.file("tri.ply")));  // Most are parts of scenes.
}

TEST_CASE("USD is refused by its name") {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.usda");
  write_text(path, "#usda 1.0\n");
  std::string said;
  try {
    load_scene(path);
  } catch (const Error& error) {
    said = error.what();
  }
  CHECK(said.starts_with(path +
                         ": \".usda\" is not the extension of a scene file, for USD is not read yet; valid"));
}

}  // namespace twinray::test
