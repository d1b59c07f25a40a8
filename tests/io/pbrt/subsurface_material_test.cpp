// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/subsurface_material.h"

#include <algorithm>

#include "core/subsurface.h"
#include "core/textured_material.h"
#include "io/pbrt/measured_media.h"
#include "tests/support/catch.h"
#include "tests/support/pbrt_text.h"
#include "tests/support/round_trip.h"
#include "tests/support/text.h"

namespace twinray::test {
namespace {

Material body_material(const std::string& text) {
  const LoadedScene loaded = load_pbrt_world("Material " + text);
  CHECK(loaded.warnings.empty());
  return loaded.scene.materials.at(1);
}

std::string material_warning(const std::string& text) {
  const LoadedScene loaded = load_pbrt_world("Material " + text);
  return loaded.warnings.empty() ? "" : loaded.warnings[0].message;
}

const CoatedDiffuse& coated_base(const Material& material) { return std::get<CoatedDiffuse>(material.model); }

std::string material_error(const std::string& text) { return pbrt_error("Material " + text); }

}  // namespace

TEST_CASE("pbrt's subsurface by what comes out of it, and by how far light goes") {
  const Material body = body_material(
      "\"subsurface\" \"rgb reflectance\" [ 0.8 0.4 0 ] \"rgb mfp\" [ 1 0.5 0.25 ] \"float scale\" 2 "
      "\"float g\" 0.3 \"float eta\" 1.5 \"float roughness\" 0.25");
  CHECK(body.subsurface == Subsurface{{2, 1, 0.5f}, 0.3f});
  CHECK(coated_base(body).ior == 1.5f);
  CHECK(coated_base(body).roughness == Roughness{0.5f, 0.5f});
  CHECK(coated_base(body).reflectance == base_of_emerging(coated_base(body), {0.8f, 0.4f, 0}));
  CHECK(body_material("\"subsurface\" \"rgb reflectance\" [ 1 1 1 ]").subsurface == Subsurface{{1, 1, 1}});
  CHECK(coated_base(body_material("\"subsurface\"")).ior == 1.33f);
}

TEST_CASE("pbrt's subsurface by what the body absorbs and scatters, by a name, or skin") {
  const Material body = body_material(
      "\"subsurface\" \"rgb sigma_a\" [ 1 0 2 ] \"rgb sigma_s\" [ 3 4 0 ] \"float scale\" 0.5 \"float g\" "
      "0.2");
  CHECK(body.subsurface == Subsurface{{0.5f, 0.5f, 1}, 0.2f});
  CHECK(coated_base(body).reflectance.r == diffuse_reflectance(0.75f, 0.2f));
  CHECK(coated_base(body).reflectance.g == 1);
  CHECK(coated_base(body).reflectance.b == 0);
  const MeasuredMedium& marble = *measured_medium("Marble");
  const Material named = body_material("\"subsurface\" \"string name\" \"Marble\" \"float scale\" 10");
  CHECK(named.subsurface.radius.r == Approx(0.1f / (marble.absorption.r + marble.scattering.r)));
  CHECK(coated_base(named).reflectance.b ==
        Approx(diffuse_reflectance(marble.scattering.b / (marble.absorption.b + marble.scattering.b), 0)));
  CHECK(body_material("\"subsurface\"").subsurface.radius.r == Approx(1 / (0.0011f + 2.55f)));
  // What neither absorbs nor scatters shows nothing.
  const Material nothing =
      body_material("\"subsurface\" \"rgb sigma_a\" [ 0 0 0 ] \"rgb sigma_s\" [ 0 0 0 ]");
  CHECK(is_finite(nothing.subsurface.radius));
  CHECK(is_black(coated_base(nothing).reflectance));
}

TEST_CASE("a texture of what comes out of a body is that at each point") {
  const LoadedScene loaded = load_pbrt_world(
      "Texture \"t\" \"spectrum\" \"constant\" \"rgb value\" [ 0.5 0.25 1 ] "
      "Material \"subsurface\" \"texture reflectance\" \"t\" \"float eta\" 1.5");
  const Material& body = loaded.scene.materials.at(1);
  REQUIRE(body.textures.size() == 1);
  CHECK(body.textures[0].meaning == InputMeaning::emerging);
  const auto at_point = std::get<CoatedDiffuse>(textured_model(body, loaded.scene.textures, {}));
  CHECK(at_point.reflectance == base_of_emerging(at_point, {0.5f, 0.25f, 1}));
}

TEST_CASE("a subsurface material that says two things, or half of one, is refused") {
  CHECK(contains(material_error("\"subsurface\" \"rgb sigma_a\" [ 1 1 1 ]"),
                 "needs both \"sigma_a\" and \"sigma_s\""));
  CHECK(contains(material_error("\"subsurface\" \"rgb sigma_s\" [ 1 1 1 ]"),
                 "needs both \"sigma_a\" and \"sigma_s\""));
  CHECK(contains(material_error("\"subsurface\" \"rgb sigma_a\" [ 1 1 1 ] \"rgb sigma_s\" [ 1 1 1 ] "
                                "\"rgb reflectance\" [ 1 1 1 ]"),
                 "\"reflectance\" or \"sigma_a\", not both"));
  CHECK(contains(material_error("\"subsurface\" \"string name\" \"Marble\" \"rgb reflectance\" [ 1 1 1 ]"),
                 "\"name\" or \"reflectance\", not both"));
  CHECK(contains(material_error("\"subsurface\" \"string name\" \"Marbel\""),
                 "there is no measured medium \"Marbel\"; \"Marble\" is the nearest name"));
  CHECK(contains(material_error("\"subsurface\" \"float g\" 2"), "\"g\" is 2"));
  CHECK(material_warning("\"subsurface\" \"float mfp\" 1") ==
        "without a \"reflectance\", \"mfp\" says nothing");
}

TEST_CASE("OpenPBR's subsurface has its own colour, weight and ways") {
  const Material whole = body_material(
      "\"openpbr\" \"rgb base_color\" [ 1 0 1 ] \"float subsurface_weight\" 0.5 "
      "\"rgb subsurface_color\" [ 0.5 0.25 1 ] \"float subsurface_radius\" 4 "
      "\"float subsurface_scatter_anisotropy\" 1");
  CHECK(std::get<Principled>(whole.model).base_color == Rgb{1, 0, 1});
  CHECK(std::get<Principled>(whole.model).subsurface_color == Rgb{0.5f, 0.25f, 1});
  CHECK(std::get<Principled>(whole.model).subsurface_weight == 0.5f);
  CHECK(whole.subsurface == Subsurface{{4, 2, 1}, 0.99f});
  CHECK(body_material("\"openpbr\" \"float subsurface_weight\" 1 \"rgb subsurface_radius_scale\" [ 2 3 4 ]")
            .subsurface == Subsurface{{2, 3, 4}});
  CHECK_FALSE(has_subsurface(body_material("\"openpbr\" \"rgb subsurface_color\" [ 1 0 0 ]")));
  CHECK(contains(material_error("\"openpbr\" \"float subsurface_weight\" 2"), "it lies in [0, 1]"));
  CHECK(material_warning("\"openpbr\" \"float subsurface_weight\" 1 \"bool geometry_thin_walled\" true") ==
        "light below a sheet is not rendered; a diffuse surface stands for it");
}

TEST_CASE("a radius of 0 is none, and one that is short in a channel at least a thousandth of the others'") {
  CHECK_FALSE(
      has_subsurface(body_material("\"subsurface\" \"rgb reflectance\" [ 1 1 1 ] \"float scale\" 0")));
  CHECK_FALSE(has_subsurface(
      body_material("\"openpbr\" \"float subsurface_weight\" 1 \"float subsurface_radius\" 0")));
  CHECK(body_material("\"subsurface\" \"rgb reflectance\" [ 1 1 1 ] \"rgb mfp\" [ 2 1 0 ]").subsurface ==
        Subsurface{{2, 1, 0.002f}});
}

TEST_CASE("OpenPBR's subsurface may have textures for its colour and its weight") {
  const Material material =
      load_pbrt_world(
          "Texture \"c\" \"spectrum\" \"constant\" \"rgb value\" [ 0.5 0.25 1 ] "
          "Texture \"w\" \"float\" \"constant\" \"float value\" [ 0 ] "
          "Material \"openpbr\" \"texture subsurface_color\" \"c\" \"texture subsurface_weight\" \"w\"")
          .scene.materials.at(1);
  CHECK(material.textures.size() == 2);
  CHECK(has_subsurface(material));
}

TEST_CASE("written pbrt: a body comes back, and what pbrt's cannot be is named") {
  Scene scene = scene_of(SphereSet{"ball", {{{0, 0, 0}, 1}}}, CoatedDiffuse{{0.8f, 0.5f, 0.2f}, {}, 1.5f});
  scene.materials[0].subsurface = {{1, 0.5f, 0.25f}, 0.5f};
  const RoundTrip trip = round_trip(scene, "a.pbrt");
  CHECK(trip.warnings.empty());
  CHECK(contains(trip.text, "\"subsurface\""));
  CHECK(only_material(trip).subsurface == scene.materials[0].subsurface);
  CHECK(coated_base(only_material(trip)).reflectance.g == Approx(0.5).epsilon(1e-4));
  // OpenPBR's, where it is the larger part of what is diffuse.
  Principled model{
      .base_color = {1, 0, 0}, .subsurface_weight = 0.6f, .subsurface_color = {0.8f, 0.5f, 0.2f}};
  scene.materials[0].model = model;
  const RoundTrip larger = round_trip(scene, "a.pbrt");
  CHECK(only_material(larger).subsurface == scene.materials[0].subsurface);
  CHECK(coated_base(only_material(larger)).reflectance.g == Approx(0.5).epsilon(1e-4));
  model.subsurface_weight = 0.4f;
  scene.materials[0].model = model;
  const RoundTrip lesser = round_trip(scene, "a.pbrt");
  CHECK_FALSE(has_subsurface(only_material(lesser)));
  CHECK(coated_base(only_material(lesser)).reflectance == Rgb{1, 0, 0});
  CHECK(contains(lesser.warnings.back(),
                 "light below the surface of a material of the type openpbr is left out"));
  const std::vector<std::string> lost = round_trip(scene, "a.gltf").warnings;
  CHECK(std::count(lost.begin(), lost.end(), "light below the surface of a material is left out") == 1);
}

}  // namespace twinray::test
