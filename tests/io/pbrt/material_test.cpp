// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/material.h"

#include <fmt/format.h>

#include <cmath>

#include "io/pbrt/spectrum.h"

#include "tests/support/catch.h"
#include "tests/support/pbrt_text.h"

namespace twinray {
namespace {

using test::load_pbrt_text;
using test::load_pbrt_world;
using test::pbrt_error;

template <typename Model>
Model model_of(const std::string& material) {
  const LoadedScene loaded = load_pbrt_world("Material " + material);
  CHECK(loaded.warnings.empty());
  REQUIRE(loaded.scene.materials.size() == 2);
  return std::get<Model>(loaded.scene.materials[1].model);
}

std::string warning_of(const std::string& statements) {
  const LoadedScene loaded = load_pbrt_world(statements);
  return loaded.warnings.empty() ? "" : loaded.warnings[0].message;
}

}  // namespace

TEST_CASE("an index below 1 of a coat, and roughnesses out of range, are named where they stand") {
  for (const char* coated :
       {"\"coateddiffuse\" \"float eta\" 0.6", "\"coatedconductor\" \"float interface.eta\" 0.6"})
    CHECK(warning_of(std::string("Material ") + coated) ==
          "a coat of the index 0.6 is not rendered: it is taken as 1");
  CHECK(warning_of("Material \"coateddiffuse\" \"float eta\" 1") == "");
  CHECK(warning_of("Material \"dielectric\" \"float eta\" 0.6") == "");
  const LoadedScene rough = load_pbrt_world(
      "Material \"coatedconductor\"\n  \"float interface.roughness\" 0.1\n  \"float conductor.roughness\" 7");
  REQUIRE(rough.warnings.size() == 1);
  CHECK(rough.warnings[0].message == "a roughness of 7 is taken as the nearest one in [0, 1]");
  const auto line_of = [](const LoadedScene& loaded) { return loaded.warnings[0].place.line; };
  CHECK(line_of(rough) == line_of(load_pbrt_world("Material \"coateddiffuse\" \"float roughness\" 7")) + 2);
}

TEST_CASE("each material becomes its model, with pbrt's values where the file has none") {
  CHECK(model_of<Lambert>("\"diffuse\"").reflectance == Rgb{0.5f, 0.5f, 0.5f});
  CHECK(model_of<Lambert>("\"diffuse\" \"rgb reflectance\" [ .1 .2 .3 ]").reflectance ==
        Rgb{0.1f, 0.2f, 0.3f});
  CHECK(model_of<Dielectric>("\"dielectric\"").ior == 1.5f);
  CHECK(model_of<Dielectric>("\"dielectric\" \"spectrum eta\" \"glass-LASF9\"").ior == Approx(1.8556));
  CHECK_FALSE(model_of<Dielectric>("\"dielectric\"").is_thin);
  CHECK(model_of<Dielectric>("\"thindielectric\" \"float eta\" 1.3").is_thin);
  CHECK(model_of<Conductor>("\"conductor\"").eta == named_spectrum("metal-Cu-eta")->color);
  CHECK(model_of<Conductor>("\"conductor\" \"rgb k\" [ 3 2 1 ]").k == Rgb{3, 2, 1});
  CHECK(model_of<CoatedDiffuse>("\"coateddiffuse\" \"float eta\" 1.4").ior == 1.4f);
  CHECK(model_of<Dielectric>("\"dielectric\" \"float eta\" 1.33").ior == 1.33f);
  CHECK(model_of<Dielectric>("\"dielectric\" \"float eta\" 1000").ior == 1000);
  const auto leaf = model_of<DiffuseTransmission>("\"diffusetransmission\" \"float scale\" 0.5");
  CHECK(leaf.transmittance == Rgb{0.125f, 0.125f, 0.125f});
}

TEST_CASE("a sheet keeps its proportions, with pictures and without, where it would scatter too much") {
  const std::string leaf = "Material \"diffusetransmission\" \"rgb transmittance\" [ .5 .25 .1 ] ",
                    reflects = leaf + "\"rgb reflectance\" [ .75 .8 .9 ]";
  CHECK(warning_of(reflects) == "this surface would scatter 1.25 of the light; it scatters all of it");
  const auto sheet = [](const std::string& statement) {
    return std::get<DiffuseTransmission>(load_pbrt_world(statement).scene.materials[1].model);
  };
  CHECK(sheet(reflects).reflectance == Rgb{0.75f, 0.8f, 0.9f});
  CHECK(sheet(reflects).transmittance == Rgb{0.5f, 0.25f, 0.1f});
  CHECK(sheet(reflects + " \"float scale\" 2").reflectance == Rgb{1, 1, 1});
}

TEST_CASE("a surface of OpenPBR has its parameters by name, and its defaults") {
  const auto plain = model_of<Principled>("\"openpbr\"");
  CHECK(plain.base_color == Rgb{0.8f, 0.8f, 0.8f});
  CHECK(plain.specular_roughness == 0.3f);
  CHECK(plain.coat_ior == 1.6f);
  const auto m = model_of<Principled>(
      "\"openpbr\" \"rgb base_color\" [ .1 .2 .3 ] \"float base_metalness\" 0.25 \"float specular_ior\" 1.4 "
      "\"float coat_weight\" 0.5 \"rgb fuzz_color\" [ .3 .2 .1 ] \"bool geometry_thin_walled\" true "
      "\"float specular_roughness_anisotropy\" 0.125 \"float thin_film_weight\" 0.5 "
      "\"float thin_film_thickness\" 1.5 \"float thin_film_ior\" 1.25");
  CHECK(m.base_color == Rgb{0.1f, 0.2f, 0.3f});
  CHECK(m.base_metalness == 0.25f);
  CHECK(m.specular_ior == Approx(1.4));
  CHECK(m.coat_weight == 0.5f);
  CHECK(m.fuzz_color == Rgb{0.3f, 0.2f, 0.1f});
  CHECK(m.specular_roughness_anisotropy == 0.125f);
  CHECK(m.geometry_thin_walled);
  CHECK(m.thin_film_weight == 0.5f);
  CHECK(m.thin_film_thickness == 1.5f);
  CHECK(m.thin_film_ior == 1.25f);
  CHECK(pbrt_error("Material \"openpbr\" \"float thin_film_thickness\" -1").find("thin_film_thickness") !=
        std::string::npos);
  CHECK(pbrt_error("Material \"openpbr\" \"float thin_film_ior\" 0.5")
            .find("\"thin_film_ior\" is 0.5; it lies in [1, 100]") != std::string::npos);
  CHECK(pbrt_error("Material \"openpbr\" \"float coat_ior\" 0.9")
            .find("\"coat_ior\" is 0.9; it lies in [1, 100]") != std::string::npos);
  CHECK(pbrt_error("Material \"openpbr\" \"float thin_film_ior\" 101")
            .find("\"thin_film_ior\" is 101; it lies in [1, 100]") != std::string::npos);
  CHECK(pbrt_error("Material \"openpbr\" \"float specular_ior\" 1001").find("lies in (0, 1000]") !=
        std::string::npos);
  CHECK(pbrt_error("Material \"openpbr\" \"float coat_weight\" 1.5")
            .find("\"coat_weight\" is 1.5; it lies in [0, 1]") != std::string::npos);
  CHECK(pbrt_error("Material \"openpbr\" \"float emission_luminance\" 1e9").find("emission_luminance") !=
        std::string::npos);
  CHECK(warning_of("Material \"openpbr\" \"float coat_wieght\" 1").find("\"coat_weight\" is") !=
        std::string::npos);
}

TEST_CASE("a clear surface of OpenPBR absorbs within, and one that emits is a light") {
  const LoadedScene loaded = load_pbrt_world(
      "Material \"openpbr\" \"float transmission_weight\" 1 \"rgb transmission_color\" [ 1 0.5 0 ] \"float "
      "transmission_depth\" 2 " +
      test::pbrt_triangle +
      "Material \"openpbr\" \"float emission_luminance\" 3 \"rgb emission_color\" [ 1 0.5 0 ] " +
      test::pbrt_triangle);
  const Scene& scene = loaded.scene;
  const Rgb& absorption = scene.materials[scene.bindings[0].material].interior.absorption;
  CHECK(absorption.r == 0);
  CHECK(absorption.g == Approx(std::log(2.0) / 2));
  CHECK(absorption.b > 4);
  CHECK(scene.bindings[0].light == no_light);
  REQUIRE(scene.lights.size() == 1);
  CHECK(scene.bindings[1].light == 0);
  const Rgb radiance = std::get<MeshLight>(scene.lights[0].source).radiance;
  CHECK(radiance == Rgb{3, 1.5f, 0});
}

TEST_CASE("what OpenPBR's surface emits is tinted by its coat, and in a mix there is less of it") {
  const std::string emitting = "\"float emission_luminance\" 2 ";
  const auto radiance = [&](const std::string& statements) {
    const Scene scene = load_pbrt_world(statements + test::pbrt_triangle).scene;
    return scene.lights.empty() ? Rgb{} : std::get<MeshLight>(scene.lights[0].source).radiance;
  };
  CHECK(radiance("Material \"openpbr\" " + emitting +
                 "\"float coat_weight\" 0.5 \"float coat_ior\" 3 "
                 "\"rgb coat_color\" [ 1 0.5 0 ] ") == Rgb{1.75f, 1.375f, 1});
  const std::string parts = "MakeNamedMaterial \"a\" \"string type\" \"openpbr\" " + emitting +
                            "MakeNamedMaterial \"b\" \"string type\" \"diffuse\" ";
  CHECK(radiance(parts + "Material \"mix\" \"string materials\" [ \"a\" \"b\" ] \"float amount\" 0.25 ") ==
        Rgb{1.5f, 1.5f, 1.5f});
  CHECK(radiance(parts + "NamedMaterial \"b\" ") == Rgb{});
}

TEST_CASE("mixes are in each other up to ten deep") {
  std::string statements = "MakeNamedMaterial \"0\" \"string type\" \"diffuse\" ";
  const auto nest = [&](int i) {
    statements += fmt::format(
        "MakeNamedMaterial \"{0}\" \"string type\" \"mix\" \"string materials\" "
        "[ \"{1}\" \"{1}\" ] ",
        i, i - 1);
  };
  for (int i = 1; i <= 10; ++i) nest(i);
  CHECK(load_pbrt_world(statements).scene.materials.size() >= 11);
  nest(11);
  CHECK(pbrt_error(statements).find("mixes may be in each other up to 10 deep") != std::string::npos);
}

TEST_CASE("a clear body's own absorption stays where a medium is around it alone") {
  const Scene scene = load_pbrt_world(
                          "MakeNamedMedium \"tea\" \"string type\" \"homogeneous\" \"rgb sigma_s\" [ 0 0 0 ] "
                          "MediumInterface \"\" \"tea\" Material \"openpbr\" \"float transmission_weight\" 1 "
                          "\"rgb transmission_color\" [ 1 0.5 0.5 ] \"float transmission_depth\" 1 " +
                          test::pbrt_triangle)
                          .scene;
  const Interior& interior = scene.materials[scene.bindings[0].material].interior;
  CHECK(interior.absorption.g == Approx(std::log(2.0)));
  CHECK_FALSE(interior.is_clear);
}

TEST_CASE("a roughness is the square of alpha, unless it is not remapped") {
  const auto alpha = [](const std::string& more) {
    return model_of<Conductor>("\"conductor\" " + more).roughness;
  };
  CHECK(alpha("\"float roughness\" 0.25") == Roughness{0.5f, 0.5f});
  CHECK(alpha("\"float roughness\" 0.25 \"bool remaproughness\" false") == Roughness{0.25f, 0.25f});
  CHECK(alpha("\"float uroughness\" 0.04 \"float vroughness\" 0.25") == Roughness{0.2f, 0.5f});
  CHECK(alpha("\"float uroughness\" 0.04") == Roughness{0.2f, 0});
  CHECK(alpha("\"float roughness\" 9e-7") == Roughness{});
  CHECK(alpha("") == Roughness{});
}

TEST_CASE("a metal of a reflectance has it where light falls straight on it") {
  const auto metal = model_of<Conductor>("\"conductor\" \"rgb reflectance\" [ 0.9 0.5 0 ]");
  CHECK(metal.eta == Rgb{1, 1, 1});
  const auto reflected = [](float k) { return k * k / (4 + k * k); };
  CHECK(reflected(metal.k.r) == Approx(0.9));
  CHECK(reflected(metal.k.g) == Approx(0.5));
  CHECK(metal.k.b == 0);
  CHECK(pbrt_error("Material \"conductor\" \"rgb reflectance\" [ 1 1 1 ] \"rgb eta\" [ 1 1 1 ]")
            .find("a metal has \"reflectance\" or \"eta\" and \"k\", not both") != std::string::npos);
}

TEST_CASE("how pbrt follows light below a coat is named where it is not as usual") {
  const auto warnings = [](const std::string& words) {
    std::string all;
    for (const char* material : {"coateddiffuse", "coatedconductor"})
      for (const Diagnostic& warning : test::load_pbrt_world("Material \"" + std::string(material) + "\" " +
                                                             words + "\n" + test::pbrt_triangle)
                                           .warnings)
        all += warning.message + "\n";
    return all;
  };
  CHECK(warnings("\"float thickness\" 0.01 \"integer maxdepth\" 10 \"integer nsamples\" 4 \"float g\" 0")
            .empty());
  const std::string thick = "what pbrt's coats absorb by their thickness is not rendered\n";
  CHECK(warnings("\"float thickness\" 0.011") == thick + thick);
  CHECK(load_pbrt_world("Texture \"t\" \"float\" \"constant\" \"float value\" 0.02\n"
                        "Material \"coateddiffuse\" \"texture thickness\" \"t\"\n" +
                        test::pbrt_triangle)
                .warnings.back()
                .message +
            "\n" ==
        thick);
  const std::string shallow = "light between the layers is followed to its end\n";
  CHECK(warnings("\"integer maxdepth\" 9") == shallow + shallow);
}

TEST_CASE("the layers of a coated conductor have names of their own") {
  const auto coated = model_of<CoatedConductor>(
      "\"coatedconductor\" \"float interface.roughness\" 0.04 \"float conductor.roughness\" 0.25 \"float "
      "interface.eta\" 1.7 \"rgb conductor.eta\" [ 1 2 3 ] \"rgb conductor.k\" [ 4 5 6 ]");
  CHECK(coated.coat_roughness == Roughness{0.2f, 0.2f});
  CHECK(coated.roughness == Roughness{0.5f, 0.5f});
  CHECK(coated.coat_ior == Approx(1.7));
  CHECK(coated.eta == Rgb{1, 2, 3});
  CHECK(coated.k == Rgb{4, 5, 6});
}

TEST_CASE("named materials may be used before they are made, and a mix is of those before it") {
  const LoadedScene loaded = load_pbrt_world(
      "NamedMaterial \"late\" " + test::pbrt_triangle +
      "MakeNamedMaterial \"a\" \"string type\" \"diffuse\" MakeNamedMaterial \"late\" \"string type\" "
      "\"dielectric\" MakeNamedMaterial \"both\" \"string type\" \"mix\" \"string materials\" [ \"a\" "
      "\"late\" ] "
      "\"float amount\" 0.3");
  const Scene& scene = loaded.scene;
  CHECK(std::holds_alternative<Dielectric>(scene.materials[scene.bindings[0].material].model));
  const Mix mix = std::get<Mix>(scene.materials.back().model);
  CHECK(scene.materials[mix.first].name == "a");
  CHECK(scene.materials[mix.second].name == "late");
  CHECK(mix.amount == 0.3f);
  CHECK(pbrt_error("NamedMaterial \"gless\" MakeNamedMaterial \"glass\" \"string type\" \"dielectric\"")
            .find("no MakeNamedMaterial makes \"gless\"; \"glass\" is the nearest one") != std::string::npos);
  CHECK(pbrt_error("MakeNamedMaterial \"m\" \"string type\" \"mix\" \"string materials\" [ \"m\" \"m\" ]")
            .find("a mix is of materials that are made before it; \"m\" is not") != std::string::npos);
}

TEST_CASE("hair has the colour of its pigments, and pbrt's roughnesses") {
  const auto color = [](const std::string& parameters) {
    const LoadedScene loaded = load_pbrt_world("Material \"hair\" " + parameters);
    CHECK(loaded.warnings.empty());
    return std::get<Hair>(loaded.scene.materials.at(1).model).reflectance;
  };
  const Rgb black = color("\"float eumelanin\" 8"), blonde = color("\"float eumelanin\" 0.2"),
            red = color("\"float pheomelanin\" 2"), brown = color("");
  CHECK(max_component(black) < 0.001f);
  CHECK(blonde.r == Approx(std::exp(-5.9 * std::sqrt(0.2 * 0.419))).epsilon(0.03));
  CHECK(blonde.r > 2 * blonde.b);
  CHECK(red.r > 3 * red.g);
  CHECK(max_component(brown) < blonde.r);
  CHECK(max_component(black) < max_component(brown));
  CHECK(color("\"rgb sigma_a\" [ 0 0 0 ]") == Rgb{1, 1, 1});
  CHECK(color("\"rgb reflectance\" [ 0.5 0.25 0.125 ]") == Rgb{0.5f, 0.25f, 0.125f});
  CHECK(color("\"rgb color\" [ 0.5 0.25 0.125 ]") == Rgb{0.5f, 0.25f, 0.125f});
  const LoadedScene loaded = load_pbrt_world(
      "Material \"hair\" \"float beta_m\" 0.25 \"float beta_n\" 0.5 \"float alpha\" 3 \"float eta\" 1.5");
  const Hair hair = std::get<Hair>(loaded.scene.materials.at(1).model);
  CHECK(hair.longitudinal_roughness == 0.25f);
  CHECK(hair.azimuthal_roughness == 0.5f);
  CHECK(hair.scale_tilt == 3);
  CHECK(hair.ior == 1.5f);
  CHECK(pbrt_error("Material \"hair\" \"float beta_m\" 1.5").find("beta_m") != std::string::npos);
}

TEST_CASE("of several colours of hair the first that pbrt asks for counts, and the others are named") {
  const LoadedScene loaded = load_pbrt_world(
      "Material \"hair\" \"rgb sigma_a\" [ 0 0 0 ] \"rgb reflectance\" [ 0.1 0.2 0.3 ] \"float eumelanin\" "
      "2");
  CHECK(std::get<Hair>(loaded.scene.materials.at(1).model).reflectance == Rgb{1, 1, 1});
  REQUIRE(loaded.warnings.size() == 2);
  CHECK(loaded.warnings[0].message == "\"reflectance\" has no effect: \"sigma_a\" says the colour");
  CHECK(loaded.warnings[1].message == "\"eumelanin\" has no effect: \"sigma_a\" says the colour");
  const LoadedScene textured = load_pbrt_world(
      "Texture \"t\" \"float\" \"constant\" \"float value\" 1.4 Material \"hair\" \"texture eta\" \"t\"");
  CHECK(std::get<Hair>(textured.scene.materials.at(1).model).ior == 1.4f);
}

TEST_CASE("hair has no sides: what turns shapes around does not turn it, and no medium is in it") {
  const std::string curve = " Shape \"curve\" \"point3 P\" [ 0 0 0  0 0 1  0 0 2  0 0 3 ] ";
  const LoadedScene loaded = load_pbrt_world("Material \"hair\"" + curve + "ReverseOrientation" + curve);
  const Geometry& geometry = *loaded.scene.geometry;
  CHECK(geometry.mesh(0)->triangles == geometry.mesh(1)->triangles);
  CHECK(geometry.mesh(0)->normals == geometry.mesh(1)->normals);
  const LoadedScene filled = load_pbrt_world(
      "MakeNamedMedium \"m\" \"string type\" \"homogeneous\" MediumInterface \"m\" \"\" Material \"hair\"" +
      curve);
  REQUIRE(filled.warnings.size() == 1);
  CHECK(filled.warnings[0].message.find("a medium is rendered within") == 0);
}

TEST_CASE("hair's reflectance may be a texture's, and its curves are round") {
  const LoadedScene loaded = load_pbrt_world(
      "Texture \"t\" \"spectrum\" \"checkerboard\" Material \"hair\" \"texture reflectance\" \"t\" "
      "Shape \"curve\" \"point3 P\" [ 0 0 0  0 0 1  0 0 2  0 0 3 ] "
      "Material \"diffuse\" Shape \"curve\" \"point3 P\" [ 0 0 0  0 0 1  0 0 2  0 0 3 ]");
  CHECK(loaded.warnings.empty());
  REQUIRE(loaded.scene.materials.at(1).textures.size() == 1);
  CHECK(loaded.scene.materials[1].textures[0].input == MaterialInput::reflectance);
  // Eight sides and two ends of six triangles, against four sides.
  CHECK(loaded.scene.geometry->mesh(0)->triangles.size() == 16 + 12);
  CHECK(loaded.scene.geometry->mesh(1)->triangles.size() == 8);
}

TEST_CASE("a material that there is not, and a reflectance above 1, are errors") {
  CHECK(pbrt_error("Material \"plastic\"").find("there is no material \"plastic\"; valid are diffuse") !=
        std::string::npos);
  CHECK(pbrt_error("Material \"diffuse\" \"rgb reflectance\" [ 1 1.5 1 ]")
            .find("\"reflectance\" is 1 1.5 1; each must lie in [0, 1]") != std::string::npos);
}

TEST_CASE("an interface is no surface") {
  CHECK(load_pbrt_world("Material \"interface\" " + test::pbrt_triangle).scene.geometry->triangle_count() ==
        0);
  const LoadedScene lit =
      load_pbrt_world("Material \"interface\" AreaLightSource \"diffuse\" " + test::pbrt_triangle);
  CHECK(lit.scene.lights.empty());
  REQUIRE(lit.warnings.size() == 1);
  CHECK(lit.warnings[0].message == "an area light on an interface is left out, as pbrt does");
}

}  // namespace twinray
