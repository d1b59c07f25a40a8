// SPDX-License-Identifier: Apache-2.0
#include "io/collada/effect.h"

#include "tests/support/catch.h"
#include "tests/support/collada_text.h"

namespace twinray {
namespace {

const std::string images =
    "<library_images><image id=\"wood\"><init_from>pictures/wood.png</init_from></image>"
    "<image id=\"stone\"><init_from><ref>pictures/stone.png</ref></init_from></image></library_images>";

/// The triangle in a material whose effect's profile holds this, instanced with these settings.
LoadedScene load_painted(const std::string& profile, const std::string& settings = "") {
  return load_collada(collada_text(
      images +
          collada_mesh(3, "0 0 0 1 0 0 0 1 0",
                       "<triangles material=\"paint\" count=\"1\"><input semantic=\"VERTEX\" "
                       "source=\"#vertices\" offset=\"0\"/><p>0 1 2</p></triangles>") +
          "<library_effects><effect id=\"fx\"><profile_COMMON>" + profile +
          "</profile_COMMON></effect></library_effects><library_materials><material "
          "id=\"m\"><instance_effect "
          "url=\"#fx\">" +
          settings + "</instance_effect></material></library_materials>",
      "<node><instance_geometry url=\"#shape\"><bind_material><technique_common><instance_material "
      "symbol=\"paint\" target=\"#m\"/></technique_common></bind_material></instance_geometry></node>"));
}

LoadedScene load_shading(const std::string& model, const std::string& slots) {
  return load_painted("<technique><" + model + ">" + slots + "</" + model + "></technique>");
}

Rgb reflectance(const LoadedScene& loaded) {
  return std::get<Lambert>(loaded.scene.materials[loaded.scene.bindings[0].material].model).reflectance;
}

std::string transparency_warning(const std::string& opacity) {
  return "transparency is not rendered; this surface is opaque, and the file makes its opacity " + opacity;
}

}  // namespace

TEST_CASE("the diffuse color is read from each of the shading models that have one") {
  for (const std::string model : {"lambert", "phong", "blinn"}) {
    const LoadedScene loaded = load_shading(model, "<diffuse><color>0.1 0.2 0.3 1</color></diffuse>");
    CHECK(reflectance(loaded) == Rgb{0.1f, 0.2f, 0.3f});
    CHECK(messages(loaded).empty());
  }
}

TEST_CASE("a constant surface emits its color and reflects nothing") {
  const LoadedScene loaded = load_shading("constant", "<emission><color>1 2 3 1</color></emission>");
  CHECK(reflectance(loaded) == Rgb{0, 0, 0});
  REQUIRE(loaded.scene.lights.size() == 1);
  CHECK(std::get<MeshLight>(loaded.scene.lights[0].source).radiance == Rgb{1, 2, 3});
}

TEST_CASE("a color may be a parameter, which the instance may set") {
  const std::string shading =
      "<technique><lambert><diffuse><param ref=\"tint\"/></diffuse></lambert></technique>";
  const std::string parameter = "<newparam sid=\"tint\"><float4>0.1 0.2 0.3 1</float4></newparam>";
  CHECK(reflectance(load_painted(parameter + shading)) == Rgb{0.1f, 0.2f, 0.3f});
  const LoadedScene set =
      load_painted(parameter + shading, "<setparam ref=\"tint\"><float3>0.5 0.6 0.7</float3></setparam>");
  CHECK(reflectance(set) == Rgb{0.5f, 0.6f, 0.7f});
  CHECK(messages(set).empty());
}

TEST_CASE("a texture leads to its image file, by whatever way it is referred to") {
  const auto named = [](const std::string& parameters, const std::string& texture) {
    return messages(load_painted(parameters + "<technique><lambert><diffuse><texture texture=\"" + texture +
                                 "\" texcoord=\"UV\"/></diffuse></lambert></technique>"));
  };
  const auto warning = [](const std::string& name) {
    return std::vector<std::string>{name + ": there is no such file; it is shown magenta",
                                    "<triangles> has no texture coordinates, which its texture needs; it has "
                                    "the color of the picture's lower left corner"};
  };
  const std::string surface =
      "<newparam sid=\"surface\"><surface type=\"2D\"><init_from>wood</init_from></surface></newparam>";
  const std::string sampler_1_4 =
      "<newparam sid=\"sampler\"><sampler2D><source>surface</source></sampler2D></newparam>";
  const std::string sampler_1_5 =
      "<newparam sid=\"sampler\"><sampler2D><instance_image url=\"#stone\"/></sampler2D></newparam>";
  CHECK(named(surface + sampler_1_4, "sampler") == warning("pictures/wood.png"));
  CHECK(named(sampler_1_5, "sampler") == warning("pictures/stone.png"));
  CHECK(named("", "wood") == warning("pictures/wood.png"));
  CHECK(named("", "nowhere") ==
        std::vector<std::string>{"the texture \"nowhere\" leads to no <image>; the surface is grey (0.5)"});
}

TEST_CASE("an emission texture that leads nowhere is named, and the surface emits nothing") {
  const LoadedScene loaded = load_shading(
      "phong",
      "<emission><texture texture=\"nowhere\" texcoord=\"UV\"/></emission><diffuse><color>1 1 1 1"
      "</color></diffuse>");
  CHECK(messages(loaded) ==
        std::vector<std::string>{"the texture \"nowhere\" leads to no <image>; this surface emits nothing"});
  CHECK(loaded.scene.lights.empty());
}

TEST_CASE("transparency is told in each opaque mode, and opaque surfaces are no matter") {
  const auto of = [](const std::string& slots) { return messages(load_shading("phong", slots)); };
  const auto with = [&](const std::string& mode, const std::string& color, const std::string& amount) {
    return of("<transparent opaque=\"" + mode + "\"><color>" + color +
              "</color></transparent><transparency><float>" + amount + "</float></transparency>");
  };
  const auto warning = [](const std::string& opacity) {
    return std::vector<std::string>{transparency_warning(opacity)};
  };
  CHECK(with("A_ONE", "0 0 0 0.5", "0.5") == warning("0.25"));
  CHECK(with("A_ZERO", "0 0 0 0.5", "0.5") == warning("0.75"));
  CHECK(with("RGB_ONE", "0.9 0.6 0.3 0", "0.5") == warning("0.3"));
  CHECK(with("RGB_ZERO", "0.9 0.6 0.3 1", "0.5") == warning("0.7"));
  CHECK(of("<transparency><float>0.25</float></transparency>") == warning("0.25"));
  CHECK(of("<transparent><color>1 1 1 0.5</color></transparent>") == warning("0.5"));
  CHECK(of("").empty());
  CHECK(with("A_ONE", "0 0 0 1", "1").empty());
  CHECK(with("A_ZERO", "1 1 1 0", "1").empty());
  CHECK(with("RGB_ONE", "1 1 1 0", "1").empty());
  CHECK(with("RGB_ZERO", "0 0 0 1", "1").empty());
  CHECK(of("<transparent><texture texture=\"nowhere\" texcoord=\"UV\"/></transparent>") ==
        std::vector<std::string>{"the texture \"nowhere\" leads to no <image>; this surface is opaque"});
}

TEST_CASE("mirror reflection is told where there is some") {
  const std::string warning =
      "<reflective> is not rendered; a mirror is a CGL extension in the <extra> of the effect";
  const auto of = [](const std::string& color, const std::string& amount) {
    return messages(load_shading("phong", "<reflective><color>" + color +
                                              "</color></reflective><reflectivity><float>" + amount +
                                              "</float></reflectivity>"));
  };
  CHECK(of("0.5 0 0 1", "0.5") == std::vector<std::string>{warning});
  CHECK(of("0 0 0 1", "0.5").empty());
  CHECK(of("1 1 1 1", "0").empty());
}

TEST_CASE("an effect without a common profile is grey, and said to be") {
  const LoadedScene loaded = load_painted("<technique/>");
  REQUIRE(loaded.warnings.size() == 1);
  CHECK(loaded.warnings[0].message.find("this <effect> has no <phong>") == 0);
  CHECK(reflectance(loaded) == Rgb{0.5f, 0.5f, 0.5f});
}

TEST_CASE("transparency and reflection that make no sense are warnings, for they are not rendered") {
  const auto of = [](const std::string& slots) { return messages(load_shading("phong", slots)); };
  const std::vector<std::string> transparency{
      "the transparency of this surface makes no sense; the surface is opaque"};
  CHECK(of("<transparency/>") == transparency);
  CHECK(of("<transparency><float>0,5</float></transparency>") == transparency);
  CHECK(of("<transparent><param ref=\"none\"/></transparent>") == transparency);
  CHECK(of("<transparent opaque=\"ALL\"><color>1 1 1 1</color></transparent>") == transparency);
  CHECK(of("<reflective/>") ==
        std::vector<std::string>{"the reflection of this surface makes no sense, and is left out"});
}

TEST_CASE("a specular texture is noted as a specular color is") {
  const LoadedScene loaded =
      load_shading("phong", "<specular><texture texture=\"wood\" texcoord=\"UV\"/></specular>");
  REQUIRE(loaded.summary.notes.size() == 1);
  CHECK(loaded.summary.notes[0] ==
        "materials reflect evenly (Lambert); the specular color of \"m\" is left out");
}

TEST_CASE(
    "a surface of which only an emission texture that leads nowhere is known is grey, to be seen at all") {
  const LoadedScene loaded =
      load_shading("constant", "<emission><texture texture=\"nowhere\" texcoord=\"UV\"/></emission>");
  CHECK(reflectance(loaded) == Rgb{0.5f, 0.5f, 0.5f});
  CHECK(messages(loaded) ==
        std::vector<std::string>{"the texture \"nowhere\" leads to no <image>; this surface is grey (0.5), "
                                 "and emits nothing"});
}

}  // namespace twinray
