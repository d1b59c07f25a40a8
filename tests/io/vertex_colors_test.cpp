// SPDX-License-Identifier: Apache-2.0
#include "io/vertex_colors.h"

#include <array>
#include <string>
#include <vector>

#include "io/picture/srgb.h"
#include "io/ply/scene.h"
#include "tests/support/catch.h"
#include "tests/support/obj_text.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {
namespace {

/// Bilinear weights have eight bits' rounding of texture coordinates behind them.
constexpr float tolerance = 1e-5f;

/// The scene of a PLY file of a square whose vertices have these colors, of this type.
LoadedScene load_ply_colors(const std::string& type, const std::vector<std::string>& colors,
                            const std::array<const char*, 3>& names = {"red", "green", "blue"}) {
  std::string text = "ply\nformat ascii 1.0\nelement vertex 4\n";
  for (const char* name : {"x", "y", "z"}) text += std::string("property float ") + name + "\n";
  for (const char* name : names) text += "property " + type + " " + name + "\n";
  text += "element face 2\nproperty list uchar int vertex_indices\nend_header\n";
  const char* const corners[] = {"0 0 0 ", "1 0 0 ", "1 1 0 ", "0 1 0 "};
  for (std::size_t i = 0; i < 4; ++i) text += corners[i] + colors[i] + "\n";
  const TemporaryFolder folder;
  write_text(folder.file("a.ply"), text + "3 0 1 2\n3 0 2 3\n");
  return load_ply(folder.file("a.ply"), {});
}

/// What a triangle's surface reflects where its second and third corner have these weights.
Rgb color_at(const LoadedScene& loaded, std::uint32_t triangle, float u, float v) {
  const Mesh& mesh = *loaded.scene.geometry->mesh(0);
  const auto& [a, b, c] = mesh.uv_indices.at(triangle);
  const Vec2 uv = mesh.uvs[a] * (1 - u - v) + mesh.uvs[b] * u + mesh.uvs[c] * v;
  const Material& material = loaded.scene.materials[loaded.scene.bindings[0].material];
  return evaluate(loaded.scene.textures, material.textures.at(0).texture, {.uv = uv, .footprint = 10});
}

void check_near(const Rgb& a, const Rgb& b) {
  CAPTURE(a.r, a.g, a.b, b.r, b.g, b.b);
  CHECK(max_component(a - b) <= tolerance);
  CHECK(max_component(b - a) <= tolerance);
}

const std::vector<std::string> four{"255 0 0", "0 255 0", "0 0 255", "188 188 188"};

}  // namespace

TEST_CASE("colors of a PLY file's vertices are mixed as their triangles do, from any distance") {
  const LoadedScene loaded = load_ply_colors("uchar", four);
  const Rgb grey = Rgb{1, 1, 1} * decode_srgb(188 / 255.0f);
  check_near(color_at(loaded, 0, 0, 0), {1, 0, 0});
  check_near(color_at(loaded, 0, 1, 0), {0, 1, 0});
  check_near(color_at(loaded, 0, 0, 1), {0, 0, 1});
  check_near(color_at(loaded, 0, 0.25f, 0.5f), {0.25f, 0.25f, 0.5f});
  check_near(color_at(loaded, 1, 0, 1), grey);
  check_near(color_at(loaded, 1, 0.5f, 0.5f), Rgb{0, 0, 0.5f} + grey * 0.5f);
  CHECK(loaded.warnings.empty());
}

TEST_CASE("colors of vertices are bytes, words or numbers up to 1, within which they are kept") {
  const LoadedScene words = load_ply_colors("ushort", {"65535 13107 0", "0 0 0", "0 0 0", "0 0 0"});
  check_near(color_at(words, 0, 0, 0), {1, decode_srgb(0.2f), 0});
  const LoadedScene numbers = load_ply_colors("float", {"1 0 7", "-1 0 0", "0 0 0", "0 0 0"});
  check_near(color_at(numbers, 0, 0, 0), {1, 0, 1});
  check_near(color_at(numbers, 0, 1, 0), {0, 0, 0});
}

TEST_CASE("colors of vertices go by several names") {
  using Names = std::array<const char*, 3>;
  for (const Names& names : {Names{"diffuse_red", "diffuse_green", "diffuse_blue"}, Names{"r", "g", "b"}})
    check_near(color_at(load_ply_colors("uchar", four, names), 0, 1, 0), {0, 1, 0});
}

TEST_CASE("what a PLY file has and is not read is told") {
  const TemporaryFolder folder;
  const auto notes = [&](const std::string& comment, const std::string& property, const std::string& value,
                         const std::string& element) {
    write_text(folder.file("tri.ply"),
               "ply\nformat ascii 1.0\n" + comment +
                   "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                   "element face 1\nproperty list uchar int vertex_indices\n" +
                   property + element + "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2" + value + "\n4 0 1 2 0\n");
    return load_ply(folder.file("tri.ply")).summary.notes;
  };
  using Notes = std::vector<std::string>;
  CHECK(notes("comment made by hand\n", "", "", "").empty());
  CHECK(notes("", "property uchar red\n", " 255", "") == Notes{"colors of faces are left out"});
  // Once, of however many lists of faces.
  CHECK(notes("", "property uchar red\n", " 255",
              "element face 1\nproperty uchar red\nproperty list uchar int vertex_indices\n") ==
        Notes{"faces of less than three corners, left out: 1", "colors of faces are left out"});
  CHECK(notes("", "property list uchar float texcoord\n", " 6 0 0 1 0 0 1", "") ==
        Notes{"texture coordinates of faces' corners are left out"});
  CHECK(notes("comment TextureFile a.png\n", "", "", "") ==
        Notes{"pictures (\"comment TextureFile\") are left out"});
  CHECK(notes("", "", "", "element tristrips 1\nproperty list int int vertex_indices\n") ==
        Notes{"strips of triangles (\"tristrips\") are left out"});
}

TEST_CASE("vertices of one color are a surface of that color") {
  const LoadedScene loaded = load_ply_colors("uchar", {"255 0 0", "255 0 0", "255 0 0", "255 0 0"});
  CHECK(loaded.scene.textures.empty());
  CHECK(std::get<Lambert>(loaded.scene.materials[0].model).reflectance == Rgb{1, 0, 0});
}

TEST_CASE("colors behind an OBJ file's coordinates are those of its vertices, where no picture is") {
  const std::string vertices = "v 9 9 9\nv 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0  0 0 1 \n";
  const LoadedScene plain = load_obj_text(vertices + "f 2 3 4\n");
  check_near(color_at(plain, 0, 0, 0), {1, 0, 0});
  check_near(color_at(plain, 0, 0.5f, 0.25f), {0.25f, 0.5f, 0.25f});
  CHECK(plain.summary.notes.empty());
  const LoadedScene late = load_obj_text("v 0 0 0\nv 1 0 0\nv 0 1 0 0 0 1\nf 1 2 3\n");
  check_near(color_at(late, 0, 0, 0), {1, 1, 1});
  const std::string material = "mtllib a.mtl\nvt 0 0\n" + vertices + "usemtl m\nf 2/1 3/1 4/1\n";
  const auto textures = [&](const std::string& lines) {
    const LoadedScene loaded = load_obj_text(material, {{"a.mtl", "newmtl m\n" + lines}});
    return loaded.scene.materials[loaded.scene.bindings[0].material].textures.size();
  };
  CHECK(textures("Kd 0.5 0.5 0.5\n") == 1);
  CHECK(textures("Kd 0 0 0\nKs 1 1 1\nillum 3\n") == 0);  // A mirror reflects by another color.
  const LoadedScene textured = load_obj_text(material, {{"a.mtl", "newmtl m\nmap_Kd none.png\n"}});
  CHECK(textured.scene.geometry->mesh(0)->uvs == std::vector<Vec2>{{0, 0}});
}

TEST_CASE("colors of an OBJ file's vertices are bytes where no fractions of 1 can be meant") {
  const auto load = [](const std::string& second) {
    return load_obj_text("v 0 0 0 51 0 0\nv 1 0 0 " + second + "\nv 0 1 0 1 1 1\nf 1 2 3\n");
  };
  using Notes = std::vector<std::string>;
  for (const char* second : {"0 255 0", "0 255.0 0", "127.5 255 0"}) {
    CAPTURE(second);
    const LoadedScene loaded = load(second);
    check_near(color_at(loaded, 0, 0, 0), {decode_srgb(0.2f), 0, 0});
    CHECK(color_at(loaded, 0, 1, 0).g == 1);
    CHECK(loaded.summary.notes == Notes{"colors of vertices are taken for bytes: the largest number is 255"});
  }
  CHECK(load("0 300 0").summary.notes ==
        Notes{"colors of vertices are taken for bytes: the largest number is 300",
              "colors of vertices above 255 are taken as 255"});
  // Brighter than white, as some programs write light.
  const LoadedScene bright = load_obj_text("v 0 0 0 1.5 0.5 0\nv 1 0 0 0 2 0\nv 0 1 0 0 0 0\nf 1 2 3\n");
  check_near(color_at(bright, 0, 0, 0), {1, decode_srgb(0.5f), 0});
  CHECK(bright.summary.notes == Notes{"colors of vertices above 1 are taken as 1"});
}

TEST_CASE("an alpha behind the color of an OBJ file's vertex is left out, and told") {
  const LoadedScene loaded = load_obj_text("v 0 0 0 1 0 0 0.5\nv 1 0 0 0 1 0 1\nv 0 1 0 0 0 1 1\nf 1 2 3\n");
  check_near(color_at(loaded, 0, 0, 0), {1, 0, 0});
  check_near(color_at(loaded, 0, 0, 1), {0, 0, 1});
  CHECK(loaded.summary.notes ==
        std::vector<std::string>{"alphas of vertices, behind their colors, are left out"});
  const LoadedScene longer = load_obj_text("v 0 0 0 1 0 0 1 9\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  CHECK(longer.scene.textures.empty());
}

TEST_CASE("ZBrush's colors of an OBJ file are those of the vertices before them") {
  const std::string square = "v 9 9 9\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
  const LoadedScene loaded = load_obj_text(square +
                                           "# as ZBrush writes #MRGB 11\n#MRGB ffff0000ff00FF00\r\n"
                                           "#MRGB 000000ffffbcbcbc\nv 8 8 8\nf 2 3 4 5\n");
  const Rgb grey = white * decode_srgb(188 / 255.0f);
  check_near(color_at(loaded, 0, 0, 0), {1, 0, 0});
  check_near(color_at(loaded, 0, 1, 0), {0, 1, 0});
  check_near(color_at(loaded, 0, 0, 1), {0, 0, 1});
  check_near(color_at(loaded, 1, 0, 1), grey);
  CHECK(loaded.summary.notes.empty());
  const LoadedScene beyond = load_obj_text(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
      "#MRGB ff0000ffff00ff00ff00ff00ffff0000\n");
  check_near(color_at(beyond, 0, 0, 0), {0, 0, 1});
  CHECK(beyond.summary.notes == std::vector<std::string>{"colors (\"#MRGB\") of no vertex, left out: 1"});
}

TEST_CASE("a material of an OBJ file whose faces are all painted stands only as the painted one") {
  const std::string vertices = "vt 0 0\nv 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\n";
  const auto names = [](const LoadedScene& loaded) {
    std::vector<std::string> all;
    for (const ShapeBinding& binding : loaded.scene.bindings)
      all.push_back(loaded.scene.materials.at(binding.material).name);
    CHECK(loaded.scene.materials.size() == loaded.scene.bindings.size());
    return all;
  };
  CHECK(names(load_obj_text(vertices + "f 1 2 3\n")) == std::vector<std::string>{"none"});
  const LoadedScene two = load_obj_text(
      "mtllib a.mtl\n" + vertices + "usemtl m\nf 1/1 2/1 3/1\nusemtl n\nf 1/1 2/1 3/1\nusemtl o\nf 1 2 3\n",
      {{"a.mtl", "newmtl m\nKd 1 1 1\nnewmtl n\nmap_Kd none.png\nnewmtl o\nKd 0 1 0\n"}});
  CHECK(names(two) == std::vector<std::string>{"m", "n", "o"});
}

}  // namespace twinray::test
