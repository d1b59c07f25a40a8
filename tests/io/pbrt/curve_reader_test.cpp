// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/curve_reader.h"

#include <cmath>

#include "tests/support/catch.h"
#include "tests/support/pbrt_text.h"
#include "tests/support/text.h"

namespace twinray {
namespace {

const std::string four = "\"point3 P\" [ 0 0 0  1 0 0  2 0 0  3 0 0 ]";

std::string curve_error(const std::string& parameters) {
  return test::pbrt_error("Shape \"curve\" " + parameters);
}

}  // namespace

TEST_CASE("curves of pbrt are tubes where they stand, and ribbons") {
  const LoadedScene loaded = test::load_pbrt_world(
      "Translate 0 5 0 Shape \"curve\" \"float width\" 0.5 \"string type\" \"cylinder\" " + four +
      "Shape \"curve\" \"string type\" \"ribbon\" \"normal N\" [ 0 0 1 0 0 1 ] " + four +
      "Shape \"curve\" \"float width0\" 1 \"float width1\" 0.25 \"integer splitdepth\" 1 " + four);
  CHECK(loaded.warnings.empty());
  REQUIRE(loaded.scene.geometry->shapes().size() == 3);
  CHECK(loaded.scene.geometry->mesh(0)->triangles.size() == 16);
  CHECK(loaded.scene.geometry->mesh(1)->triangles.size() == 2);
  CHECK(loaded.scene.geometry->mesh(2)->triangles.size() == 8);
  CHECK(loaded.scene.geometry->bounds().lower.y > 4);
  const auto radius = [&](const Vec3& p) { return std::hypot(p.y - 5, p.z); };
  const std::vector<Vec3>& tube = loaded.scene.geometry->mesh(0)->positions;
  for (const Vec3& p : tube) CHECK(radius(p) == Approx(radius(tube[0])).epsilon(1e-5));
  CHECK(radius(tube[0]) == Approx(0.25).epsilon(0.03));
}

TEST_CASE("normals of a curve that is no ribbon are named") {
  const LoadedScene loaded = test::load_pbrt_world("Shape \"curve\" \"normal N\" [ 0 0 1 0 0 1 ] " + four);
  REQUIRE(loaded.warnings.size() == 1);
  CHECK(loaded.warnings[0].message == "\"N\" has no effect: the curve is no ribbon");
}

TEST_CASE("curves that are none are refused where they stand") {
  const auto refuses = [](const std::string& parameters, const std::string& message) {
    CAPTURE(parameters, curve_error(parameters));
    CHECK(curve_error(parameters).starts_with("scene.pbrt:2:"));
    CHECK(test::contains(curve_error(parameters), message));
  };
  refuses("", "a curve of 0 points; valid are 4, and 3 more for each further segment");
  refuses("\"point3 P\" [ 0 0 0 1 1 1 2 2 2 3 3 3 4 4 4 ]", "a curve of 5 points; valid are 4, and 3 more");
  refuses("\"integer degree\" 2 " + four,
          "a curve of 4 points; valid are 3, and 2 more for each further segment");
  refuses("\"string basis\" \"bspline\" \"point3 P\" [ 0 0 0 1 1 1 2 2 2 ]",
          "a curve of 3 points; valid are 4 or more");
  refuses("\"string type\" \"round\" " + four,
          "there is no type \"round\"; valid are flat, cylinder or ribbon");
  refuses("\"string basis\" \"nurbs\" " + four, "there is no basis \"nurbs\"; valid are bezier or bspline");
  refuses("\"integer degree\" 4 " + four, "degree");
  refuses("\"float width0\" -1 " + four, "width0");
  refuses("\"string type\" \"ribbon\" " + four,
          "a ribbon of 1 segments needs 2 normals, \"normal N\"; here are 0");
}

}  // namespace twinray
