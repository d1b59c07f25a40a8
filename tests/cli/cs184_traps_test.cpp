// SPDX-License-Identifier: Apache-2.0
// The traps of CS184's program, in the order of docs/cs184.md: what this one does at each.
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <set>

#include "tests/support/catch.h"
#include "tests/support/cs184_scene.h"

namespace twinray::test {
namespace {

const Rgb blue{0, 0, 1}, green{0, 1, 0}, red{1, 0, 0};

/// How many pixels have this colour.
int count_of(const Image& image, const Rgb& color) {
  return int(std::count(image.pixels.begin(), image.pixels.end(), color));
}

/// The share of pixels that differ in a channel by more than one step of 255.
double share_off(const Image& a, const Image& b, int dx, int dy) {
  constexpr float step = 1.5f / 255;
  int off = 0;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      const Rgb &p = a.at(x, y), &q = b.at(x + dx, y + dy);
      off += std::max({std::fabs(p.r - q.r), std::fabs(p.g - q.g), std::fabs(p.b - q.b)}) > step;
    }
  return off / double(a.pixels.size());
}

/// "traced 123 rays" -> 123
long traced_rays(const ProcessResult& result) {
  return std::stol(result.out.substr(result.out.find("traced ") + 7));
}

const std::string normals = "--integrator=normals ";

/// A closed tetrahedron around the origin, fronts outward.
const Cs184Mesh tetrahedron{4, "1 1 1 1 -1 -1 -1 1 -1 -1 -1 1", 4, "0 1 2 0 3 1 0 2 3 1 3 2", ""};

Cs184Scene one_mesh(const Cs184Mesh& mesh) {
  Cs184Scene scene;
  scene.geometries = cs184_geometry("floor", mesh);
  return scene;
}

Cs184Scene under_light(const std::string& light, const std::string& matrix) {
  Cs184Scene scene;
  scene.libraries = cs184_light(light);
  scene.nodes += cs184_node(matrix, "<instance_light url=\"#light\"/>");
  return scene;
}

Cs184Scene under_point(const std::string& height) {
  return under_light(
      "<point><color>10 10 10</color><constant_attenuation>1</constant_attenuation><linear_attenuation>0"
      "</linear_attenuation><quadratic_attenuation>0.00111109</quadratic_attenuation></point>",
      moved_by("0", height, "0"));
}

}  // namespace

TEST_CASE("trap 1: sampling is always adaptive, and -a with all samples and tolerance 0 turns it off") {
  const Cs184Scene scene = lit_floor();
  const TemporaryFolder folder;
  REQUIRE(run_cs184(folder, scene, "-r 16 300 -s 64 -f a.png").exit_code == 0);
  const Image rates = read_image(folder.file("a_rate.png"));
  CHECK(count_of(rates, green) > 0);  // 32 of 64: nothing is seen there
  CHECK(count_of(rates, blue) == 0);
  const Cs184Scene even =
      under_light("<directional><color>1 1 1</color></directional>", moved_by("0", "5", "1"));
  REQUIRE(run_cs184(folder, even, "-r 16 12 -s 64 -f even.png").exit_code == 0);
  CHECK(count_of(read_image(folder.file("even_rate.png")), green) == 16 * 12);
  REQUIRE(run_cs184(folder, scene, "-r 16 12 -s 64 -a 64 0 -f b.png").exit_code == 0);
  CHECK(count_of(read_image(folder.file("b_rate.png")), red) == 16 * 12);
  REQUIRE(run_cs184(folder, scene, "-r 16 12 -s 1 -a 1 0 -f c.png").exit_code == 0);
  CHECK(count_of(read_image(folder.file("c_rate.png")), red) == 16 * 12);
}

TEST_CASE("trap 2: a larger resolution shows more, and the same in its middle") {
  const Image part = cs184_picture(lit_floor(), normals + "-r 60 44", "a.png");
  const Image whole = cs184_picture(lit_floor(), normals + "-r 480 360", "a.png");
  CHECK(share_off(part, whole, 210, 158) <= 0.002);
  CHECK(count_of(part, {}) == 0);  // The floor fills 60 x 44 pixels
  CHECK(count_of(whole, {}) > 0);  // and not 480 x 360.
}

TEST_CASE("trap 3: a camera gives its direction alone, seen from the origin and not from its place") {
  Cs184Scene near = lit_floor(), far = lit_floor();
  near.camera_matrix = moved_by("0", "2", "4");   // one unit in front of it: 0 2 3
  far.camera_matrix = moved_by("0", "20", "31");  // 0 20 30
  const std::string options = normals + "-r 64 48";
  CHECK(share_off(cs184_picture(near, options, "a.png"), cs184_picture(far, options, "a.png"), 0, 0) <=
        0.002);
  // Half a unit up in front of the origin, looking along the floor: seen from (0, 0.5, 1), that is from
  // above.
  Cs184Scene level = lit_floor();
  level.camera_matrix = moved_by("0", "0.5", "2");
  CHECK(count_of(cs184_picture(level, normals + "-r 60 20", "a.png"), {}) == 0);
  Cs184Scene rolled = lit_floor();
  rolled.camera_matrix = "0 -1 0 0 1 0 0 2 0 0 1 4 0 0 0 1";
  CHECK(cs184_picture(near, options).pixels == cs184_picture(rolled, options).pixels);
}

TEST_CASE("trap 4: the normals of an open mesh are turned, those of a closed one point outward") {
  const Image open = cs184_picture(one_mesh(floor_mesh), normals + "-r 8 6");
  CHECK(open.at(4, 3) == Rgb{0.5f, 0, 0.5f});  // (0, -1, 0) for a floor whose front is up
  Cs184Scene closed = one_mesh(tetrahedron);
  closed.camera_matrix = moved_by("4", "4", "5");
  const Rgb corner = cs184_picture(closed, normals + "-r 8 6").at(4, 3);
  CHECK(std::min({corner.r, corner.g, corner.b}) > 0.5f);
  // Its normal points down, and light from above is scattered upward all the same; light from below is not.
  const std::string sun = "<directional><color>1 1 1</color></directional>";
  CHECK(mean_luminance(cs184_picture(under_light(sun, moved_by("0", "5", "1")), "-r 8 6")) > 0.1);
  CHECK(mean_luminance(cs184_picture(under_light(sun, moved_by("0", "-5", "1")), "-r 8 6")) == 0);
}

TEST_CASE("trap 5: light and hemisphere sampling converge to one picture") {
  // 192 pixels of 4096 samples each: their mean is known to a part in 300 by the hemisphere.
  const std::string options = "-r 16 12 -s 4096 -a 4096 0 -t 2 ";
  const double lights = mean_luminance(cs184_picture(lit_floor(), options));
  CHECK(mean_luminance(cs184_picture(lit_floor(), options + "-H")) == Approx(lights).epsilon(0.02));
  // The hemisphere finds ambient light as well, and no light of a single direction.
  const Cs184Scene open = under_light("<ambient><color>1 1 1</color></ambient>", moved_by("0", "0", "0"));
  const std::string part = "-r 16 12 -s 64 -l 64 -a 64 0 -p 4 3 8 6 ";
  CHECK(mean_luminance(cs184_picture(open, part)) == Approx(0.5).epsilon(0.01));
  CHECK(mean_luminance(cs184_picture(open, part + "-H")) == Approx(0.5).epsilon(0.01));
  CHECK(mean_luminance(cs184_picture(under_point("50"), part + "-H")) == 0);
}

TEST_CASE("trap 6: a lamp's mesh at the place of its area light takes no light away") {
  Cs184Scene without_mesh = lit_floor();
  // Something as high as the lamp, so that the camera stands at one place.
  without_mesh.geometries += cs184_geometry("mast", {3, "-2 0 -2 -1.9 0 -2 -2 2 -2", 1, "0 1 2", ""});
  without_mesh.nodes += cs184_node(moved_by("0", "0", "0"), "<instance_geometry url=\"#mast\"/>");
  Cs184Scene with_mesh = without_mesh;
  with_mesh.geometries += cs184_geometry(
      "lamp",
      {4, "-0.4 1.49999 -0.3 0.4 1.49999 -0.3 0.4 1.49999 0.3 -0.4 1.49999 0.3", 2, "0 1 2 0 2 3", ""});
  with_mesh.libraries +=
      "<library_effects><effect id=\"glow\"><extra><technique profile=\"CGL\"><emission><radiance>10 10 10"
      "</radiance></emission></technique></extra></effect></library_effects><library_materials><material "
      "id=\"glow-material\" name=\"glow\"><instance_effect url=\"#glow\"/></material></library_materials>\n";
  with_mesh.nodes += cs184_node(
      moved_by("0", "0", "0"),
      "<instance_geometry url=\"#lamp\"><bind_material><technique_common><instance_material symbol=\"glow\" "
      "target=\"#glow-material\"/></technique_common></bind_material></instance_geometry>");
  const TemporaryFolder folder;  // One lamp: a floor, a mast, and the two triangles of the mesh.
  CHECK(run_cs184(folder, with_mesh, "-r 8 6 -f a.png").out.find("BVH from 5 primitives") !=
        std::string::npos);
  const std::string floor_in_front = "-r 32 24 -s 256 -a 256 0 -p 8 0 16 8 ";
  const double without = mean_luminance(cs184_picture(without_mesh, floor_in_front));
  CHECK(without > 0);
  CHECK(mean_luminance(cs184_picture(with_mesh, floor_in_front)) == Approx(without).epsilon(0.03));
}

TEST_CASE("trap 7: point lights do not fall off, and a directional light shines from its node's place") {
  const std::string options = "-r 16 12 -m 1 -p 4 3 8 6 ";
  const double near = mean_luminance(cs184_picture(under_point("50"), options));
  CHECK(near > 0);
  CHECK(mean_luminance(cs184_picture(under_point("100"), options)) == Approx(near).epsilon(0.01));
  const std::string sun = "<directional><color>1 1 1</color></directional>";
  // One unit in front of the node lies above the origin, or beside it at the height of the floor.
  const double above = mean_luminance(cs184_picture(under_light(sun, moved_by("0", "5", "1")), options));
  CHECK(above == Approx(0.5 / 3.14159265).epsilon(0.001));
  CHECK(mean_luminance(cs184_picture(under_light(sun, moved_by("5", "0", "1")), options)) < 1e-6);
}

TEST_CASE("trap 8: help ends with 0, and what cannot be read or written is an error") {
  const TemporaryFolder folder;
  CHECK(run_cs184(folder, lit_floor(), "-h").exit_code == 0);
  CHECK(run_shell("'" TWINRAY_PATHTRACER "' -f x.png none.dae").exit_code == 1);
  const ProcessResult nowhere = run_cs184(folder, lit_floor(), "-r 8 6 -f none/a.png");
  CHECK(nowhere.exit_code == 1);
  CHECK(nowhere.out.empty());
  write_text(folder.file("not.dae"), "<scene/>");
  const ProcessResult foreign =
      run_shell("cd '" + folder.path().string() + "' && '" TWINRAY_PATHTRACER "' -f a.png not.dae");
  CHECK(foreign.exit_code == 1);
  CHECK(foreign.err.find("pathtracer: not.dae:1") != std::string::npos);
}

TEST_CASE("trap 9: scripts that read either stream alone find its lines in order") {
  const TemporaryFolder folder;
  const ProcessResult result = run_cs184(folder, lit_floor(), "-r 8 6 -f a.png");
  for (const std::string& step : {std::string("Collecting"), std::string("Building"),
                                  std::string("BVH traced"), std::string("Job completed")}) {
    CHECK(result.out.find(step) != std::string::npos);
    CHECK(result.err.find(step) == std::string::npos);
  }
  for (const std::string& step :
       {std::string("Input scene"), std::string("Rendering using"), std::string("Saving to file")}) {
    CHECK(result.err.find(step) != std::string::npos);
    CHECK(result.out.find(step) == std::string::npos);
  }
}

TEST_CASE("trap 10: normals of the file are not used, and corners share one") {
  Cs184Mesh turned = tetrahedron;
  turned.normals = "1 0 0 1 0 0 1 0 0 1 0 0";
  const Image plain = cs184_picture(one_mesh(tetrahedron), normals + "-r 16 12");
  CHECK(cs184_picture(one_mesh(turned), normals + "-r 16 12").pixels == plain.pixels);
  std::set<float> reds;  // Four flat faces would have four.
  for (const Rgb& pixel : plain.pixels) reds.insert(pixel.r);
  CHECK(reds.size() > 20);
}

TEST_CASE("trap 11: cells are counted from the bottom left, and pictures stored from the top") {
  const std::string options = normals + "-r 32 24 ";
  const Image whole = cs184_picture(lit_floor(), options);
  const Image cell = cs184_picture(lit_floor(), options + "-p 4 2 10 5");
  REQUIRE(cell.width == 10);
  REQUIRE(cell.height == 5);
  for (int y = 0; y < 5; ++y)
    for (int x = 0; x < 10; ++x) CHECK(cell.at(x, y) == whole.at(4 + x, 24 - 2 - 5 + y));
}

TEST_CASE("trap 12: a PNG has three channels of eight bits, whatever it shows") {
  const TemporaryFolder folder;
  REQUIRE(run_cs184(folder, lit_floor(), "-r 8 6 -m 0 -f black.png").exit_code == 0);
  for (const char* name : {"black.png", "black_rate.png"}) {
    const std::string bytes = read_text(folder.file(name));
    CHECK(int(bytes[24]) == 8);  // bits
    CHECK(int(bytes[25]) == 2);  // RGB
  }
}

TEST_CASE("trap 13: a matrix of 15 numbers is read, with a warning, as one that ends with 0") {
  Cs184Scene short_by_one = lit_floor();
  short_by_one.camera_matrix = "1 0 0 0 0 1 0 2 0 0 1 4 0 0 0";
  const TemporaryFolder folder;
  const ProcessResult result = run_cs184(folder, short_by_one, normals + "-r 16 12 -f a.exr");
  REQUIRE(result.exit_code == 0);
  CHECK(result.err.find("warning: scene.dae:") != std::string::npos);
  CHECK(read_image(folder.file("a.exr")).pixels == cs184_picture(lit_floor(), normals + "-r 16 12").pixels);
}

TEST_CASE("not reproduced: rays that several threads trace are all counted") {
  const TemporaryFolder folder;
  const std::string options = "-r 64 48 -s 8 -m 4 -f a.exr ";
  const long one = traced_rays(run_cs184(folder, lit_floor(), options));
  const Image picture = read_image(folder.file("a.exr"));
  CHECK(traced_rays(run_cs184(folder, lit_floor(), options + "-t 4")) == one);
  CHECK(read_image(folder.file("a.exr")).pixels == picture.pixels);
}

TEST_CASE("not reproduced: a forced first bounce is not divided by the roulette's probability") {
  const std::string options = "-r 16 12 -s 2048 -a 2048 0 -t 2 -m 2 -o 0 ";
  Cs184Scene two_floors = lit_floor();
  two_floors.nodes += cs184_node("1 0 0 0 0 0 1 2 0 -1 0 -2 0 0 0 1", "<instance_geometry url=\"#floor\"/>");
  const double forced = mean_luminance(cs184_picture(two_floors, options));
  CHECK(forced > 0);
  CHECK(mean_luminance(cs184_picture(two_floors, options + "--roulette=1")) == Approx(forced).epsilon(0.01));
}

TEST_CASE("not reproduced: nodes of nothing, and elements without id or name, are no crash") {
  Cs184Scene scene = lit_floor();
  scene.nodes += "<node><matrix>" + moved_by("0", "0", "0") + "</matrix></node>\n";
  CHECK(cs184_picture(scene, normals + "-r 8 6").pixels ==
        cs184_picture(lit_floor(), normals + "-r 8 6").pixels);
}

TEST_CASE("not reproduced: a mesh that is no manifold is rendered with ordinary normals and a warning") {
  // A third triangle at one edge.
  const Cs184Mesh fan{5, "-2 0 -2 2 0 -2 2 0 2 -2 0 2 0 1 0", 3, "0 2 1 0 3 2 0 2 4", ""};
  const TemporaryFolder folder;
  const ProcessResult result = run_cs184(folder, one_mesh(fan), normals + "-r 16 12 -f a.png");
  CHECK(result.exit_code == 0);
  CHECK(result.err.find("warning: ") == result.err.find("scene.dae:") - 9);
}

}  // namespace twinray::test
