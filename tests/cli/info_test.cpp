// SPDX-License-Identifier: Apache-2.0
// twinray info: what is in a scene.
#include <fmt/format.h>

#include "io/measured/brdf_file.h"
#include "io/picture/image_file.h"
#include "tests/support/catch.h"
#include "tests/support/json.h"
#include "tests/support/measured_facets.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/text.h"

namespace twinray::test {
namespace {

const std::string scenes = TWINRAY_SOURCE_DIR "/scenes/";

nlohmann::json info_of(const std::string& scene, const std::string& more = "") {
  const ProcessResult result = run_program(fmt::format("info {} --json {}", quoted(scene), more));
  CHECK(result.exit_code == 0);
  return nlohmann::json::parse(result.out);
}

/// A leaf of one triangle with a picture, a wall of two, and a lamp, two units high.
class Leaf {
 public:
  Leaf() {
    write_png(folder_.file("leaf.png"), {4, 2, std::vector<std::uint8_t>(24, 200)});
    write_text(folder_.file("a.mtl"),
               "newmtl leaf\nmap_Kd leaf.png\nd 0.5\nnewmtl wall\nKd 1 1 1\nKs 1 1 1\nillum 2\nnewmtl lamp\n"
               "Ke 1 1 1\n");
    write_text(scene(),
               "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 2 0\nv 0 2 0\nvt 0 0\nusemtl leaf\nf 1/1 2/1 3/1\n"
               "usemtl wall\nf 1 2 3 4\nusemtl lamp\nf 2 3 4\nusemtl none\nf 1 1 2\n");
  }
  std::string scene() const { return folder_.file("a.obj"); }
  std::string file(const std::string& name) const { return folder_.file(name); }

 private:
  TemporaryFolder folder_;
};

}  // namespace

TEST_CASE("info tells what is in a scene, as JSON") {
  const Leaf leaf;
  const nlohmann::json info = info_of(leaf.scene());
  CHECK(info["scene"] == leaf.scene());
  CHECK(info["files"] == nlohmann::json{leaf.scene(), leaf.file("a.mtl"), leaf.file("leaf.png")});
  CHECK(info["triangles"] == 4);
  CHECK(info["degenerate_triangles"] == 1);
  CHECK(info["cut_out_triangles"] == 1);
  CHECK(info["bounds"]["min"] == nlohmann::json{0.0, 0.0, 0.0});
  CHECK(info["bounds"]["max"] == nlohmann::json{1.0, 2.0, 0.0});
  CHECK(info["camera"].is_null());
  CHECK(info["unit"].is_null());
  REQUIRE(info["materials"].size() == 4);
  CHECK(info["materials"][0] ==
        nlohmann::json{
            {"name", "leaf"}, {"model", "lambert"}, {"textures", 1}, {"shapes", 1}, {"triangles", 1}});
  CHECK(info["materials"][1]["model"] == "openpbr");
  CHECK(info["materials"][1]["triangles"] == 2);
  REQUIRE(info["lights"].size() == 1);
  CHECK(info["lights"][0]["kind"] == "mesh, both sides");
  CHECK(info["lights"][0]["power"][0].get<double>() == Approx(2 * 3.14159265).epsilon(1e-5));
  // A mip-map of 4 x 2, 2 x 1 and 1 x 1 pixels of three floats.
  CHECK(info["pictures"] ==
        nlohmann::json{{{"name", "leaf.png"}, {"width", 4}, {"height", 2}, {"bytes", 11 * 12}}});
  REQUIRE(info["warnings"].size() == 1);
  CHECK(contains(info["warnings"][0].get<std::string>(), "there is no material \"none\""));
}

TEST_CASE("info adds up the memory of a render") {
  const std::string box = scenes + "box.dae";
  const Leaf leaf;
  for (const std::string& scene : {box, leaf.scene()}) {
    std::uint64_t sum = 0;
    const nlohmann::json memory = info_of(scene)["memory_bytes"];
    for (const auto& [name, bytes] : memory.items())
      if (name != "all") sum += bytes.get<std::uint64_t>();
    CHECK(memory["all"] == sum);
    CHECK(memory["the film of 480 x 360 pixels"] == 480 * 360 * 64);
  }
  CHECK(info_of(box, "-r 96 72")["memory_bytes"]["the film of 96 x 72 pixels"] == 96 * 72 * 64);
  const std::string scene = leaf.file("large.pbrt");
  write_text(
      scene,
      "Film \"rgb\" \"integer xresolution\" 640 \"integer yresolution\" 20 WorldBegin Shape \"sphere\"");
  CHECK(info_of(scene)["memory_bytes"]["the film of 640 x 20 pixels"] == 640 * 20 * 64);
  CHECK(info_of(scene, "-r 96 72")["memory_bytes"]["the film of 96 x 72 pixels"] == 96 * 72 * 64);
  // Floats of positions and texture coordinates, and indices of triangles.
  const int bytes_of_leaf = 3 * 12 + 12 + 8 + 12, wall = 4 * 12 + 2 * 12, lamp = 3 * 12 + 12;

  CHECK(info_of(leaf.scene())["memory_bytes"]["geometry"] == bytes_of_leaf + wall + lamp);
}

TEST_CASE("info counts the pictures of lights, one of several once") {
  const TemporaryFolder folder;
  write_png(folder.file("a.png"), {8, 8, std::vector<std::uint8_t>(192, 200)});
  const std::string light = "LightSource \"infinite\" \"string filename\" \"a.png\"\n",
                    projection = "LightSource \"projection\" \"string filename\" \"a.png\"\n",
                    lamps =
                        "AreaLightSource \"diffuse\" \"string filename\" \"a.png\"\nShape \"bilinearmesh\" "
                        "\"point3 P\" [0 0 0 1 0 0 0 1 0 1 1 0]\n";
  const auto bytes = [&](const std::string& lights) {
    write_text(folder.file("a.pbrt"), "Camera \"perspective\"\nWorldBegin\n" + lights);
    return info_of(folder.file("a.pbrt"))["memory_bytes"]["pictures of lights"];
  };
  constexpr int picture = 8 * 8 * 12;
  CHECK(bytes("LightSource \"point\"\n") == 0);
  CHECK(bytes(light) == picture);
  CHECK(bytes(light + projection) == 2 * picture);
  CHECK(bytes(lamps) == picture);
  CHECK(bytes(lamps + "Shape \"bilinearmesh\" \"point3 P\" [0 0 1 1 0 1 0 1 1 1 1 1]\n") == picture);
}

TEST_CASE("info tells of media, and of the memory of those that are not even") {
  const TemporaryFolder folder;
  const std::string scene = folder.file("a.pbrt");
  write_text(
      scene,
      "MakeNamedMedium \"air\" \"string type\" \"homogeneous\" MediumInterface \"\" \"air\" "
      "LookAt 0 0 9  0 0 0  0 1 0 Camera \"perspective\" WorldBegin "
      "MakeNamedMedium \"m\" \"string type\" \"uniformgrid\" \"integer nx\" 2 \"float density\" [ 1 2 ] "
      "\"rgb sigma_s\" [ 0 0 0 ] MediumInterface \"m\" \"air\" Material \"interface\" Shape \"sphere\"");
  const nlohmann::json info = info_of(scene);
  CHECK(info["media"] == nlohmann::json{{"absorbing", 1},
                                        {"scattering", 1},
                                        {"uneven", 1},
                                        {"glowing", 0},
                                        {"subsurface", 0},
                                        {"atmosphere", true}});
  CHECK(info["memory_bytes"]["densities of media"] == (9 * 9 * 9 + 1) * 4);
  CHECK(contains(run_program("info " + quoted(scene)).out,
                 "media: 1 that absorb, 1 that scatter light, 1 of them not even; an atmosphere\n"));
}

TEST_CASE("info tells of the memory of measured materials, once for each measurement") {
  const TemporaryFolder folder;
  const MeasuredBrdf brdf(measured_facets(Ggx(0.4f), {1, 1, 1}, 3, 1, 4));
  write_text(folder.file("a.bsdf"), brdf_file_bytes(brdf, BrdfColors::rgb));
  const std::string ball = "Material \"measured\" \"string filename\" \"a.bsdf\" Shape \"sphere\" ";
  write_text(folder.file("a.pbrt"), "WorldBegin " + ball + ball);
  // Four angles, two tables of 4 x 4 numbers, three slices of two densities with their sums, and of colors.
  constexpr int numbers = 4 + 2 * 16 + 3 * 2 * 2 * 16 + 3 * 3 * 16;
  CHECK(info_of(folder.file("a.pbrt"))["memory_bytes"]["measured materials"] == numbers * 4);
}

TEST_CASE("info tells below how many materials light is scattered") {
  const TemporaryFolder folder;
  const std::string scene = folder.file("a.pbrt");
  write_text(scene, "WorldBegin Material \"subsurface\" Shape \"sphere\"");
  CHECK(info_of(scene)["media"]["subsurface"] == 1);
  CHECK(contains(run_program("info " + quoted(scene)).out, "light below the surface: of 1 material\n"));
}

TEST_CASE("info tells what is stored, and what instances show") {
  const std::string pawns = scenes + "pawns.pbrt";
  const nlohmann::json kept = info_of(pawns, "--instances=keep"), copied = info_of(pawns);
  CHECK(kept["instances"] == 33);
  CHECK(kept["prototypes"] == 1);
  CHECK(kept["triangles"] == 2 + 288);
  CHECK(kept["seen_primitives"] == 2 + 33 * 289);
  CHECK(copied["instances"] == 0);
  CHECK(copied["triangles"] == 2 + 33 * 288);
  CHECK(copied["seen_primitives"] == kept["seen_primitives"]);
  // A sphere's box is rounded outward before and after it is scaled.
  for (const char* end : {"min", "max"})
    for (std::size_t axis = 0; axis < 3; ++axis)
      CHECK(kept["bounds"][end][axis].get<double>() ==
            Approx(copied["bounds"][end][axis].get<double>()).epsilon(1e-6));
  const ProcessResult text = run_program("info --instances=keep " + quoted(pawns));
  CHECK(contains(text.out, "instances: 33 of 1 prototype, by which 9539 triangles and spheres are seen\n"));
}

TEST_CASE("info names options that change nothing, as render does") {
  const std::string command = "info generated:woods:10 --instances=copy";
  const ProcessResult told = run_program(command);
  CHECK(told.exit_code == 0);
  CHECK(contains(told.err, "warning: --instances: no effect, for generated scenes "));
  const ProcessResult strict = run_program(command + " --strict");
  CHECK(strict.exit_code == 2);
  CHECK(strict.out.empty());
  CHECK(contains(strict.err, "twinray: --instances: no effect, for generated scenes "));
}

TEST_CASE("info tells the same in words, of many things the largest") {
  const Leaf leaf;
  const ProcessResult result = run_program("info " + quoted(leaf.scene()));
  CHECK(result.exit_code == 0);
  CHECK(contains(result.err, "there is no material \"none\""));
  CHECK(contains(result.out,
                 "shapes: 4 meshes, 4 triangles, 0 spheres; 1 degenerate triangle dropped; 4 materials\n"));
  CHECK(contains(result.out, "bounds: 0 0 0 to 1 2 0\n"));
  CHECK(contains(result.out,
                 "material \"wall\": openpbr, 1 shape, 2 triangles\nmaterial \"leaf\": lambert, 1 shape, 1 "
                 "triangle, 1 texture"));
  CHECK(contains(result.out, "picture \"leaf.png\": 4 x 2 pixels, 132 bytes\n"));
  CHECK(contains(result.out, "memory: 11.1 MB for the film of 480 x 360 pixels\n"));
  const TemporaryFolder folder;
  std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nmtllib a.mtl\n", mtl;
  for (int i = 0; i < 25; ++i) {
    obj += fmt::format("usemtl m{}\nf 1 2 3\n", i);
    mtl += fmt::format("newmtl m{}\n", i);
  }
  write_text(folder.file("a.obj"), obj);
  write_text(folder.file("a.mtl"), mtl);
  const std::string many = run_program("info " + quoted(folder.file("a.obj"))).out;
  CHECK(contains(many, "material \"m19\""));
  CHECK(!contains(many, "material \"m20\""));
  CHECK(contains(many, "... and 5 more, which --json names\n"));
}

TEST_CASE("info refuses what render refuses") {
  CHECK(run_program("info /no/such.dae").exit_code == 1);
  CHECK(run_program("info").exit_code == 2);
  const Leaf leaf;
  CHECK(run_program("info --strict " + quoted(leaf.scene())).exit_code == 1);
}

}  // namespace twinray::test
