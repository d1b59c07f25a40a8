// SPDX-License-Identifier: Apache-2.0
// Scenes that are legal and hard. tests/large holds those that take too long for every day.
#include <fmt/format.h>

#include <algorithm>

#include "core/rgb.h"
#include "io/picture/image_file.h"
#include "tests/support/catch.h"
#include "tests/support/collada_text.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {
namespace {

const std::string triangle = "<instance_geometry url=\"#shape\"/>";

/// A camera at (0, 0, 3), which looks along -z.
const std::string camera =
    "<library_cameras><camera id=\"eye\"><optics><technique_common><perspective><xfov>60</xfov>"
    "<aspect_ratio>1.333</aspect_ratio></perspective></technique_common></optics></camera></"
    "library_cameras>\n";
const std::string camera_node = "<node><translate>0 0 3</translate><instance_camera url=\"#eye\"/></node>\n";

struct Rendered {
  ProcessResult result;
  Image image;  ///< Empty where there is no picture.
};

Rendered rendered(const std::string& text, const std::string& options) {
  const TemporaryFolder folder;
  write_text(folder.file("hard.dae"), text);
  Rendered found{run_program(fmt::format("'{}' -r 32 24 -q {} -o '{}'", folder.file("hard.dae"), options,
                                         folder.file("a.exr"))),
                 {}};
  if (found.result.exit_code == 0) found.image = read_image(folder.file("a.exr"));
  return found;
}

std::size_t lit_pixels(const Image& image) {
  return image.pixels.size() - std::size_t(std::count_if(image.pixels.begin(), image.pixels.end(), is_black));
}

std::string nested(const std::string& tag, int depth, const std::string& inner) {
  std::string text = inner;
  for (int i = 0; i < depth; ++i) text = "<" + tag + ">" + text + "</" + tag + ">";
  return text;
}

/// A box of half side `size`, whose faces look inward, with its 12 triangles as one mesh.
std::string inward_box(double size) {
  std::string positions;
  for (int corner = 0; corner < 8; ++corner)
    positions += fmt::format("{} {} {} ", corner & 1 ? size : -size, corner & 2 ? size : -size,
                             corner & 4 ? size : -size);
  return collada_mesh(8, positions,
                      "<triangles material=\"light\" count=\"12\"><input semantic=\"VERTEX\" "
                      "source=\"#vertices\" offset=\"0\"/><p>0 1 3 0 3 2 4 7 5 4 6 7 0 5 1 0 4 5 2 3 7 2 7 6 "
                      "0 2 6 0 6 4 1 7 3 1 5 7</p></triangles>\n");
}

/// Light from both sides of a surface, of radiance 1.
const std::string glow =
    "<library_effects><effect id=\"glow-effect\"><profile_COMMON><technique "
    "sid=\"t\"><lambert><emission><color>1 1 "
    "1 1</color></emission></lambert></technique></profile_COMMON></effect></library_effects>"
    "<library_materials><material id=\"glow\"><instance_effect "
    "url=\"#glow-effect\"/></material></library_materials>\n";
const std::string glowing =
    "<instance_geometry url=\"#shape\"><bind_material><technique_common><instance_material symbol=\"light\" "
    "target=\"#glow\"/></technique_common></bind_material></instance_geometry>";

}  // namespace

TEST_CASE("a hundred thousand nodes side by side are rendered") {
  std::string nodes = camera_node;
  for (int i = 0; i < 100000; ++i)
    nodes += fmt::format("<node><translate>{} {} 0</translate>{}</node>\n", 0.01 * (i % 400) - 2,
                         0.01 * (i / 400) - 1.25, triangle);
  const auto [result, image] =
      rendered(collada_text(camera + collada_triangle(), nodes), "-s 1 --integrator=normals");
  CHECK(result.err.empty());
  REQUIRE(result.exit_code == 0);
  CHECK(lit_pixels(image) > 32 * 24 / 2);
}

TEST_CASE("nodes are rendered as deep as the XML reader goes, and a message says how deep that is") {
  // The root, its library and its scene stand around the nodes.
  const auto text = [](int depth) {
    return collada_text(camera + collada_triangle(), camera_node + nested("node", depth, triangle));
  };
  const auto [result, image] = rendered(text(95), "-s 1 --integrator=normals");
  CHECK(result.err.empty());
  REQUIRE(result.exit_code == 0);
  CHECK(lit_pixels(image) > 0);
  const ProcessResult deeper = rendered(text(96), "-s 1").result;
  CHECK(deeper.exit_code == 1);
  CHECK(deeper.err.find("elements are nested more than 98 deep, the most that is read") != std::string::npos);
}

TEST_CASE("coordinates from 10^-12 to 10^12 give the same picture, and greater ones an error") {
  const auto text = [](double scale) {
    return collada_text(camera + glow + inward_box(scale),
                        fmt::format("<node>{}</node><node><translate>0 0 {}</translate>"
                                    "<instance_camera url=\"#eye\"/></node>\n",
                                    glowing, 3 * scale));
  };
  const Image expected = rendered(text(1), "-s 1").image;
  CHECK(lit_pixels(expected) > 100);
  for (const double scale : {1e-12, 1e-6, 1e6, 3e11}) {
    CAPTURE(scale);
    const auto [result, image] = rendered(text(scale), "-s 1");
    CHECK(result.err.empty());
    REQUIRE(result.exit_code == 0);
    CHECK(lit_pixels(image) == lit_pixels(expected));
  }
  const ProcessResult beyond = rendered(text(1e13), "-s 1").result;
  CHECK(beyond.exit_code == 1);
  CHECK(beyond.err.find("1e+12") != std::string::npos);
}

TEST_CASE("lights without an area are rendered: they send none") {
  const std::string area =
      "<library_lights><light id=\"area\"><technique_common><point><color>1 1 1</color></point>"
      "</technique_common><extra><technique profile=\"CGL\"><area><color>9 9 "
      "9</color></area></technique></extra>"
      "</light></library_lights>\n";
  const std::string flat_area = "<node><scale>1 0 0</scale><instance_light url=\"#area\"/></node>";
  const std::string flat_mesh = "<node><scale>0 0 0</scale>" + glowing + "</node>";
  for (const std::string& light : {flat_area, flat_mesh}) {
    CAPTURE(light);
    const auto [result, image] = rendered(collada_text(camera + area + glow + inward_box(1),
                                                       camera_node + light + "<node>" + triangle + "</node>"),
                                          "-s 4");
    CAPTURE(result.err);
    CHECK((result.exit_code == 0 || result.exit_code == 1));
    CHECK_FALSE(result.err.empty());
    CHECK(lit_pixels(image) == 0);
  }
}

TEST_CASE("a camera inside a mesh that glows sees its light everywhere") {
  const auto [result, image] = rendered(
      collada_text(camera + glow + inward_box(5), camera_node + "<node>" + glowing + "</node>"), "-s 1");
  REQUIRE(result.exit_code == 0);
  CHECK(lit_pixels(image) == 32 * 24);
}

}  // namespace twinray::test
