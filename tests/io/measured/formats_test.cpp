// SPDX-License-Identifier: Apache-2.0
// Measured materials in the formats of scenes.
#include <cmath>
#include <string>
#include <vector>

#include "core/measured_brdf.h"
#include "io/measured/brdf_file.h"
#include "tests/support/catch.h"
#include "tests/support/measured_facets.h"
#include "tests/support/meshes.h"
#include "tests/support/pbrt_text.h"
#include "tests/support/round_trip.h"
#include "tests/support/text.h"

namespace twinray::test {
namespace {

const MeasuredBrdf& brdf_of(const Material& material) { return *std::get<Measured>(material.model).brdf; }

/// The largest difference between the colors of two tables.
float apart(const MeasuredBrdf& a, const MeasuredBrdf& b) {
  float most = 0;
  for (std::size_t i = 0; i < a.reflected().values().size(); ++i) {
    const Rgb d = a.reflected().values()[i] - b.reflected().values()[i];
    for (const float channel : {d.r, d.g, d.b}) most = std::max(most, std::fabs(channel));
  }
  return most;
}

/// Two bodies of one measurement, and one of another.
Scene three_bodies() {
  Scene scene = scene_of(tetrahedron_mesh(), measured_material({0.8f, 0.5f, 0.1f}));
  scene.materials.push_back({"again", scene.materials[0].model});
  scene.materials.push_back({"other", measured_material({0.1f, 0.5f, 0.8f}, 5)});
  std::vector<Shape> shapes(3, tetrahedron_mesh());
  scene.bindings = {{0}, {1}, {2}};
  scene.geometry = std::make_shared<const Geometry>(std::move(shapes));
  return scene;
}

std::size_t times_in(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++found;
  return found;
}

}  // namespace

TEST_CASE("pbrt's measured material has its file, which is read once") {
  const std::string bytes = brdf_file_bytes(*measured_material({0.8f, 0.5f, 0.1f}).brdf, BrdfColors::rgb);
  const std::string paint = "Material \"measured\" \"string filename\" \"paint.bsdf\"\n" + pbrt_triangle;
  const LoadedScene loaded = load_pbrt_world(paint + paint, {{"paint.bsdf", bytes}});
  CHECK(loaded.warnings.empty());
  const std::vector<Material>& materials = loaded.scene.materials;
  REQUIRE(materials.size() == 3);
  CHECK(std::get<Measured>(materials[1].model).brdf == std::get<Measured>(materials[2].model).brdf);
  CHECK(apart(brdf_of(materials[1]), *measured_material({0.8f, 0.5f, 0.1f}).brdf) == 0);
}

TEST_CASE("a measured material without a file, or of a wrong one, is an error at its place") {
  CHECK(pbrt_error("Material \"measured\"")
            .starts_with("scene.pbrt:2:1: a measured material needs its file, \"string filename\""));
  CHECK(contains(pbrt_error("Material \"measured\" \"string filename\" \"a.bsdf\""), "a.bsdf"));
  const std::string error = error_text([] {
    load_pbrt_world("Material \"measured\"\n \"string filename\" \"a.bsdf\"", {{"a.bsdf", "no tensors"}});
  });
  CHECK(error.starts_with("scene.pbrt:3:2: a.bsdf: is not a tensor file, as measured materials are"));
}

TEST_CASE("a written measured material comes back: with each bit in our form, with its colors in pbrt's") {
  const Scene scene = three_bodies();
  const RoundTrip ours = round_trip(scene, "a.json"), pbrt = round_trip(scene, "a.pbrt");
  for (const RoundTrip* trip : {&ours, &pbrt}) {
    CHECK(trip->warnings.empty());
    REQUIRE(trip->scene.bindings.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) {
      const MeasuredBrdf& wanted = brdf_of(scene.materials[i]);
      const MeasuredBrdf& read = brdf_of(trip->scene.materials[trip->scene.bindings[i].material]);
      CHECK(apart(read, wanted) <= (trip == &ours ? 0 : 3e-4f));
      CHECK(read.vndf().values() == wanted.vndf().values());
      CHECK(read.phi() == wanted.phi());
    }
  }
  // A file for each measurement, not for each material.
  CHECK(times_in(ours.text, "\"file\":\"a-material-0.bsdf\"") == 2);
  CHECK(times_in(ours.text, "\"file\":\"a-material-2.bsdf\"") == 1);
  CHECK(times_in(pbrt.text, "a-1.bsdf") == 2);
  CHECK(times_in(pbrt.text, "a-2.bsdf") == 1);
}

TEST_CASE("a part of the azimuths is written to pbrt's format with a warning: pbrt refuses it") {
  const auto half = std::make_shared<const MeasuredBrdf>(measured_facets(Ggx(0.2f, 0.5f), white, 3, 5, 4, 2));
  const RoundTrip trip = round_trip(scene_of(tetrahedron_mesh(), Measured{half}), "a.pbrt");
  CHECK(trip.warnings ==
        std::vector<std::string>{"a material that was measured from a part of the azimuths is "
                                 "written as it is: pbrt refuses it"});
  CHECK(brdf_of(only_material(trip)).folds() == 2);
}

TEST_CASE("glTF has no measured materials: a diffuse surface stands there, and is named") {
  const RoundTrip trip =
      round_trip(scene_of(tetrahedron_mesh(), measured_material({0.8f, 0.5f, 0.1f})), "a.gltf");
  REQUIRE(trip.warnings.size() == 1);
  CHECK(trip.warnings[0] == "a material of the type measured is written as a diffuse surface");
  const Rgb wanted = measured_material({0.8f, 0.5f, 0.1f}).brdf->albedo();
  CHECK(std::get<Principled>(only_material(trip).model).base_color.r == Approx(wanted.r).epsilon(1e-5));
}

}  // namespace twinray::test
