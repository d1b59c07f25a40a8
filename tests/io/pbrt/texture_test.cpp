// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/texture.h"

#include <cmath>

#include "core/angle.h"
#include "core/light_set.h"
#include "core/textured_material.h"
#include "io/picture/image_file.h"
#include "tests/support/catch.h"
#include "tests/support/pbrt_text.h"
#include "tests/support/temporary_folder.h"

namespace twinray {
namespace {

using test::load_pbrt_world;

const std::string checks =
    "Texture \"checks\" \"spectrum\" \"checkerboard\" \"rgb tex1\" [ 1 0 0 ] \"float uscale\" 4 \"float "
    "vdelta\" .5\n";

/// A folder with a picture of one red and one black pixel, and a scene beside it.
struct Folder {
  Folder() {
    Image picture(2, 1);
    picture.at(0, 0) = {1, 0, 0};
    write_exr(folder.file("red.exr"), picture);
    Image sky(4, 4);
    for (Rgb& pixel : sky.pixels) pixel = {2, 2, 2};
    write_exr(folder.file("sky.exr"), sky);
  }
  LoadedScene load(const std::string& statements) const {
    test::write_text(folder.file("scene.pbrt"), "WorldBegin\n" + statements);
    return load_pbrt(folder.file("scene.pbrt"));
  }
  test::TemporaryFolder folder;
};

/// Of the first material's first texture.
Rgb reflectance_at(const LoadedScene& loaded, Vec2 uv) {
  return evaluate(loaded.scene.textures, loaded.scene.materials[1].textures.at(0).texture, {uv});
}

}  // namespace

TEST_CASE("a texture of a reflectance belongs to its material, and scaled ones name others before them") {
  const LoadedScene loaded = load_pbrt_world(
      checks +
      "Texture \"half\" \"spectrum\" \"scale\" \"texture tex\" \"checks\" \"float scale\" .5\n"
      "Material \"diffuse\" \"texture reflectance\" \"half\"\n" +
      test::pbrt_triangle);
  CHECK(loaded.warnings.empty());
  const Scene& scene = loaded.scene;
  const TextureUse use = scene.materials[1].textures.at(0);
  CHECK(use.input == MaterialInput::reflectance);
  CHECK(evaluate(scene.textures, use.texture, {{0.1f, 0.1f}}) == Rgb{0.5f, 0, 0});
  CHECK(evaluate(scene.textures, use.texture, {{0.3f, 0.1f}}) == Rgb{0, 0, 0});
  CHECK(evaluate(scene.textures, use.texture, {{0.3f, 0.6f}}) == Rgb{0.5f, 0, 0});
  CHECK(std::get<Lambert>(scene.materials[1].model).reflectance == Rgb{0.25f, 0, 0});
}

TEST_CASE("a mesh without texture coordinates has those that pbrt gives each triangle") {
  const LoadedScene loaded =
      load_pbrt_world(checks + "Material \"diffuse\" \"texture reflectance\" \"checks\" ReverseOrientation " +
                      test::pbrt_triangle);
  const Mesh& mesh = *loaded.scene.geometry->mesh(0);
  REQUIRE(mesh.uvs.size() == 3);
  for (std::size_t corner = 0; corner < 3; ++corner)  // The winding is turned, and the coordinates with it.
    CHECK(mesh.uv_indices[0][corner] == mesh.triangles[0][corner]);
  CHECK(load_pbrt_world(test::pbrt_triangle).scene.geometry->mesh(0)->uvs.empty());
}

TEST_CASE("a bilinear patch without texture coordinates has its parameters, flat or not") {
  // The corners (0, 0), (1, 0), (0, 1) and (1, 1) of each patch are where their coordinates are, times two.
  const std::string points = "\"point3 P\" [ 0 0 0  2 0 0  0 2 0  2 2 0  0 4 0  2 4 3 ] ";
  const LoadedScene loaded =
      load_pbrt_world("Shape \"bilinearmesh\" " + points + "\"integer indices\" [ 0 1 2 3  2 3 4 5 ]");
  const Mesh& mesh = *loaded.scene.geometry->mesh(0);
  REQUIRE(mesh.triangles.size() == 2 + 512);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Vec2 uv = mesh.uvs.at(mesh.uv_indices[i][corner]);
      const Vec3 p = mesh.positions[mesh.triangles[i][corner]];
      CHECK(Vec2{p.x, p.y} == Vec2{2 * uv.x, 2 * uv.y + (i < 2 ? 0.0f : 2.0f)});
    }
}

TEST_CASE("a picture is a texture, with its scale and wrap") {
  const Folder folder;
  const LoadedScene loaded = folder.load(
      "Texture \"red\" \"spectrum\" \"imagemap\" \"string filename\" \"red.exr\" \"string wrap\" \"clamp\" "
      "\"float "
      "scale\" .5\nMaterial \"diffuse\" \"texture reflectance\" \"red\"\n");
  CHECK(loaded.warnings.empty());
  CHECK(reflectance_at(loaded, {-3, 0.5f}) == Rgb{0.5f, 0, 0});
  CHECK(reflectance_at(loaded, {3, 0.5f}) == Rgb{0, 0, 0});
}

TEST_CASE("an inverted picture is white without it, and so is its mean") {
  const Folder folder;
  const LoadedScene loaded = folder.load(
      "Texture \"red\" \"spectrum\" \"imagemap\" \"string filename\" \"red.exr\" \"float scale\" .25 "
      "\"bool invert\" true \"string filter\" \"point\"\n"
      "Material \"diffuse\" \"texture reflectance\" \"red\"\n");
  CHECK(loaded.warnings.empty());
  CHECK(reflectance_at(loaded, {0.25f, 0.5f}) == Rgb{0.75f, 1, 1});
  CHECK(reflectance_at(loaded, {0.75f, 0.5f}) == Rgb{1, 1, 1});
  CHECK(std::get<Lambert>(loaded.scene.materials[1].model).reflectance == Rgb{0.875f, 1, 1});
}

TEST_CASE(
    "textures of metals, of roughness as pbrt has it, and of OpenPBR's inputs belong to their material") {
  const LoadedScene loaded = load_pbrt_world(
      checks + "Texture \"rough\" \"float\" \"checkerboard\" \"float tex1\" .25 \"float tex2\" .01\n" +
      "Material \"conductor\" \"texture reflectance\" \"checks\" \"texture roughness\" \"rough\"\n" +
      test::pbrt_triangle +
      "Material \"coatedconductor\" \"texture conductor.eta\" \"checks\" \"texture interface.roughness\" "
      "\"rough\" \"texture conductor.uroughness\" \"rough\" \"float conductor.vroughness\" .04\n" +
      test::pbrt_triangle +
      "Material \"openpbr\" \"texture base_metalness\" \"rough\" \"texture coat_color\" \"checks\"\n" +
      test::pbrt_triangle);
  CHECK(loaded.warnings.empty());
  const Scene& scene = loaded.scene;
  const auto at = [&](std::size_t material, Vec2 uv) {
    return textured_model(scene.materials[material], scene.textures, {uv});
  };
  const SurfaceModel red = at(1, {0.1f, 0.1f}), black = at(1, {0.3f, 0.1f});
  CHECK(std::get<Conductor>(red).eta == Rgb{1, 1, 1});
  CHECK(std::get<Conductor>(red).k == metal_k({1, 0, 0}));
  CHECK(std::get<Conductor>(black).k == Rgb{});
  CHECK(std::get<Conductor>(red).roughness == Roughness{0.5f, 0.5f});
  const SurfaceModel coated = at(2, {0.1f, 0.1f});
  CHECK(std::get<CoatedConductor>(coated).eta == Rgb{1, 0, 0});
  CHECK(std::get<CoatedConductor>(coated).roughness == Roughness{0.5f, 0.2f});
  CHECK(std::get<CoatedConductor>(coated).coat_roughness == Roughness{0.5f, 0.5f});
  const SurfaceModel paint = at(3, {0.1f, 0.1f});
  CHECK(std::get<Principled>(paint).base_metalness == 0.25f);
  CHECK(std::get<Principled>(paint).coat_color == Rgb{1, 0, 0});
}

TEST_CASE("a picture that is missing is named, and shows as magenta") {
  const Folder folder;
  const LoadedScene loaded = folder.load(
      "Texture \"red\" \"spectrum\" \"imagemap\" \"string filename\" \"none.exr\"\nMaterial \"diffuse\" "
      "\"texture reflectance\" \"red\"\n");
  REQUIRE(loaded.warnings.size() == 1);
  CHECK(loaded.warnings[0].message.find("none.exr") != std::string::npos);
  CHECK(evaluate(loaded.scene.textures, loaded.scene.materials[1].textures.at(0).texture, {}) ==
        Rgb{1, 0, 1});
}

TEST_CASE("an alpha cuts its shape out, of 1 leaves it whole, of 0 leaves nothing") {
  const auto shape_of = [](const std::string& alpha) {
    std::string text = test::pbrt_triangle;
    while (text.back() == '\n' || text.back() == ' ') text.pop_back();
    return text + " " + alpha + "\n";
  };
  const std::string holes = "Texture \"holes\" \"float\" \"checkerboard\" \"float uscale\" 4\n";
  const LoadedScene loaded =
      load_pbrt_world(holes + shape_of("\"texture alpha\" \"holes\"") + shape_of("\"float alpha\" .25") +
                      shape_of("\"float alpha\" 1") + shape_of("\"float alpha\" 0") +
                      "Shape \"sphere\" \"texture alpha\" \"holes\" Shape \"sphere\" \"float alpha\" .5\n");
  CHECK(loaded.warnings.empty());
  const Scene& scene = loaded.scene;
  REQUIRE(scene.bindings.size() == 5);  // Of the one of alpha 0 nothing is left.
  CHECK(evaluate(scene.textures, scene.bindings[0].alpha, {{0.1f, 0}}).r == 1);
  CHECK(evaluate(scene.textures, scene.bindings[0].alpha, {{0.3f, 0}}).r == 0);
  CHECK(scene.geometry->mesh(0)->uvs.size() == 3);
  CHECK(evaluate(scene.textures, scene.bindings[1].alpha, {}).r == 0.25f);
  CHECK(scene.bindings[2].alpha == no_texture);
  CHECK(scene.geometry->mesh(3));  // With pbrt's coordinates.
  CHECK(scene.geometry->sphere_set(4));
  const bool opaque[] = {false, false, true, false, false};
  for (std::uint32_t i = 0; i < 5; ++i) CHECK(scene.geometry->is_opaque(i) == opaque[i]);
}

TEST_CASE("a normal map is read as data, a displacement is a bump map, and one that is missing is flat") {
  const Folder folder;
  write_png(folder.folder.file("bumps.png"), {1, 1, {51, 102, 255}});
  const LoadedScene loaded = folder.load(
      "Texture \"waves\" \"float\" \"checkerboard\"\n"
      "Material \"diffuse\" \"string normalmap\" \"bumps.png\"\n" +
      test::pbrt_triangle + "Shape \"sphere\"\n" +
      "Material \"conductor\" \"texture displacement\" \"waves\" \"float uroughness\" .1\n" +
      test::pbrt_triangle + "Material \"diffuse\" \"float displacement\" 3\n" +
      "Material \"diffuse\" \"string normalmap\" \"none.png\"\n");
  const Scene& scene = loaded.scene;
  const Rgb normal = evaluate(scene.textures, scene.materials[1].normal_map, {});
  CHECK(normal.r == Approx(0.2));
  CHECK(normal.g == Approx(0.4));
  CHECK(scene.materials[1].bump_map == no_texture);
  CHECK(scene.materials[2].normal_map == no_texture);
  CHECK(evaluate(scene.textures, scene.materials[2].bump_map, {{0.5f, 0.5f}}).r == 1);
  CHECK(scene.materials[3].bump_map == no_texture);
  // Shapes have pbrt's coordinates where maps, or unequal roughnesses, ask for tangents.
  CHECK(scene.geometry->mesh(0)->uvs.size() == 3);
  CHECK(scene.geometry->mesh(1));
  CHECK(scene.geometry->mesh(2)->uvs.size() == 3);
  REQUIRE(loaded.warnings.size() == 1);
  CHECK(loaded.warnings[0].message.ends_with("there is no such file; the surface stays flat"));
  CHECK(evaluate(scene.textures, scene.materials[4].normal_map, {}) == Rgb{0.5f, 0.5f, 1});
}

TEST_CASE("a light of alpha 0 stays, for it emits") {
  const LoadedScene loaded =
      load_pbrt_world("AreaLightSource \"diffuse\" Shape \"sphere\" \"float alpha\" 0\n");
  REQUIRE(loaded.scene.lights.size() == 1);
  const LightSet lights(loaded.scene);
  CHECK(lights.is_delta(0));
}

TEST_CASE("inputs that take no texture take its mean, with a warning") {
  const LoadedScene loaded =
      load_pbrt_world(checks + "Material \"openpbr\" \"texture emission_color\" \"checks\"");
  REQUIRE(loaded.warnings.size() == 1);
  CHECK(loaded.warnings[0].message ==
        "a texture of \"emission_color\" is not rendered here: its mean stands for it");
  CHECK(std::get<Principled>(loaded.scene.materials[1].model).emission_color == Rgb{0.5f, 0, 0});
}

TEST_CASE("the picture of an infinite light is turned with it, and a square one has equal areas") {
  const Folder folder;
  const LoadedScene loaded = folder.load(
      "Translate 1 2 3 Rotate 90 0 0 1 Scale 2 2 2\nLightSource \"infinite\" \"string filename\" \"sky.exr\" "
      "\"float "
      "scale\" 3\n");
  CHECK(loaded.warnings.empty());
  const auto light = std::get<EnvironmentLight>(loaded.scene.lights.at(0).source);
  CHECK(light.layout == MapLayout::equal_area);
  CHECK(light.map->width == 4);
  CHECK(light.scale == Rgb{3, 3, 3});
  CHECK(length(light.rotation.vector({1, 0, 0}) - Vec3{0, 1, 0}) < 1e-6f);
  CHECK(light.rotation.m[0][3] == 0);
}

TEST_CASE("a projection light's frame is a camera's, its shorter side has the fov") {
  const Folder folder;
  const LoadedScene loaded = folder.load(
      "LightSource \"projection\" \"string filename\" \"red.exr\" \"float fov\" 90 \"float scale\" 5\n");
  const auto light = std::get<ProjectionLight>(loaded.scene.lights.at(0).source);
  CHECK(light.tan_half_height == Approx(1));
  CHECK(light.tan_half_width == Approx(2));
  CHECK(light.forward == Vec3{0, 0, 1});
  CHECK(light.intensity == Rgb{5, 5, 5});
}

TEST_CASE("a number's texture and a color's may have one name") {
  const LoadedScene loaded = load_pbrt_world(
      "Texture \"t\" \"spectrum\" \"constant\" \"rgb value\" [ 0.75 0.25 0.5 ]\n"
      "Texture \"t\" \"float\" \"constant\" \"float value\" 0.125\n"
      "Texture \"half\" \"spectrum\" \"scale\" \"texture tex\" \"t\" \"float scale\" 0.5\n"
      "Material \"diffuse\" \"texture reflectance\" \"half\"\n" +
      test::pbrt_triangle +
      "Material \"conductor\" \"texture roughness\" \"t\" \"bool remaproughness\" false\n" +
      test::pbrt_triangle);
  CHECK(loaded.warnings.empty());
  CHECK(std::get<Lambert>(loaded.scene.materials[1].model).reflectance == Rgb{0.375f, 0.125f, 0.25f});
  CHECK(std::get<Conductor>(loaded.scene.materials[2].model).roughness.x == 0.125f);
}

TEST_CASE("where only a texture of the other type has the name, it is that one, with a warning") {
  const LoadedScene loaded = load_pbrt_world(
      "Texture \"number\" \"float\" \"constant\" \"float value\" 0.125\n"
      "Texture \"color\" \"spectrum\" \"constant\" \"rgb value\" [ 0.25 0.75 0.5 ]\n"
      "Material \"diffuse\" \"texture reflectance\" \"number\"\n" +
      test::pbrt_triangle +
      "Material \"conductor\" \"texture roughness\" \"color\" \"bool remaproughness\" false\n" +
      test::pbrt_triangle);
  CHECK(std::get<Lambert>(loaded.scene.materials[1].model).reflectance == Rgb{0.125f, 0.125f, 0.125f});
  CHECK(std::get<Conductor>(loaded.scene.materials[2].model).roughness.x == 0.25f);
  REQUIRE(loaded.warnings.size() == 2);
  CHECK(
      loaded.warnings[0].text().starts_with("scene.pbrt:4:20: \"reflectance\" needs a texture of type "
                                            "spectrum, and \"number\" is one of type float: "
                                            "it is taken as grey, where pbrt fails\n"));
  CHECK(loaded.warnings[1].text().starts_with(
      "scene.pbrt:6:22: \"roughness\" needs a texture of type float, and \"color\" is one of type spectrum: "
      "its red stands for the number, where pbrt fails\n"));
  CHECK_THROWS_AS(test::load_pbrt_text("WorldBegin\nTexture \"t\" \"float\" \"constant\"\n"
                                       "Material \"diffuse\" \"texture reflectance\" \"t\"\n" +
                                           test::pbrt_triangle,
                                       {.strict = true}),
                  Error);
}

TEST_CASE("a picture is encoded as the scene says, and in no other way") {
  const Folder folder;
  write_png(folder.folder.file("grey.png"), ByteImage{1, 1, {128, 128, 128}});
  const auto load_as = [&](const std::string& encoding) {
    return folder.load(
        "Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"grey.png\" \"string encoding\" \"" +
        encoding + "\"\nMaterial \"diffuse\" \"texture reflectance\" \"t\"\n");
  };
  const auto value_of = [](const LoadedScene& loaded) {
    return std::get<Lambert>(loaded.scene.materials[1].model).reflectance.g;
  };
  for (const char* linear : {"linear", "gamma 1", "gamma 1.00"})
    CHECK(value_of(load_as(linear)) == Approx(128.0 / 255).margin(1e-6));
  CHECK(value_of(load_as("sRGB")) == Approx(0.21586).margin(1e-4));
  CHECK(load_as("sRGB").warnings.empty());
  CHECK(load_as("gamma 2.2").warnings.size() == 1);
  for (const std::string wrong : {"Linear", "gamma", "gamma x", "gamma nan"})
    CHECK_THROWS_WITH(load_as(wrong),
                      Catch::Contains("there is no encoding \"" + wrong + "\"; valid are sRGB"));
}

TEST_CASE("a picture is filtered as pbrt's word says, whose last one has two spellings") {
  const Folder folder;
  write_png(folder.folder.file("grey.png"), ByteImage{1, 1, {128, 128, 128}});
  const auto filter = [&](const std::string& word) {
    const LoadedScene loaded = folder.load(
        "Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"grey.png\" \"string filter\" \"" +
        word + "\"\nMaterial \"diffuse\" \"texture reflectance\" \"t\"\n");
    CHECK(loaded.warnings.empty());
    return std::get<ImageTexture>(loaded.scene.textures.at(0).model).filter;
  };
  CHECK(filter("point") == TextureFilter::nearest);
  CHECK(filter("bilinear") == TextureFilter::bilinear);
  for (const char* word : {"trilinear", "EWA", "ewa"}) CHECK(filter(word) == TextureFilter::trilinear);
  CHECK_THROWS_WITH(filter("Ewa"), Catch::Contains("there is no filter \"Ewa\"; valid are bilinear"));
}

TEST_CASE("a way to go on beyond a picture's border that is another one here is named") {
  const Folder folder;
  write_png(folder.folder.file("grey.png"), ByteImage{1, 1, {128, 128, 128}});
  const auto warnings = [&](const std::string& wrap) {
    return folder
        .load("Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"grey.png\" \"string wrap\" \"" +
              wrap + "\"\n")
        .warnings;
  };
  for (const char* known : {"repeat", "clamp", "black"}) CHECK(warnings(known).empty());
  REQUIRE(warnings("octahedralsphere").size() == 1);
  CHECK(warnings("octahedralsphere")[0].message == "\"octahedralsphere\" is not rendered; it is clamp");
}

TEST_CASE("a sheet's scale holds for its textures") {
  const LoadedScene loaded = load_pbrt_world(
      checks + "Material \"diffusetransmission\" \"texture reflectance\" \"checks\" \"float scale\" 0.25\n" +
      test::pbrt_triangle);
  CHECK(reflectance_at(loaded, {0.1f, 0.1f}) == Rgb{0.25f, 0, 0});
}

TEST_CASE("a texture's scale holds for each channel") {
  const LoadedScene loaded = load_pbrt_world(
      "Texture \"grey\" \"spectrum\" \"constant\" \"rgb value\" [ 0.5 0.5 0.5 ]\n"
      "Texture \"checks\" \"spectrum\" \"checkerboard\" \"texture tex1\" \"grey\"\n"
      "Material \"diffusetransmission\" \"texture reflectance\" \"checks\" \"float scale\" 0.5\n" +
      test::pbrt_triangle);
  CHECK(reflectance_at(loaded, {0.1f, 0.1f}) == Rgb{0.25f, 0.25f, 0.25f});
}

TEST_CASE("a spot light has pbrt's cone and soft edge") {
  const LoadedScene loaded =
      load_pbrt_world("LightSource \"spot\" \"float coneangle\" 40 \"float conedeltaangle\" 10");
  CHECK(loaded.warnings.empty());
  const auto light = std::get<SpotLight>(loaded.scene.lights.at(0).source);
  CHECK(light.falloff_angle_degrees == 80);
  CHECK(light.penumbra_degrees == 10);
  const auto warnings_under = [](const std::string& transform) {
    return load_pbrt_world(transform + " LightSource \"spot\"").warnings.size();
  };
  CHECK(warnings_under("Rotate 30 1 2 3 Scale -2 2 2") == 0);
  CHECK(warnings_under("Scale 1 2 1") == 1);
}

TEST_CASE("a spot's soft edge that is wider than its cone leaves the inner part that pbrt's cosine gives") {
  const auto penumbra_of = [](const std::string& angles) {
    const LoadedScene loaded = load_pbrt_world("LightSource \"spot\" " + angles);
    return std::get<SpotLight>(loaded.scene.lights.at(0).source).penumbra_degrees;
  };
  CHECK(penumbra_of("\"float coneangle\" 80 \"float conedeltaangle\" 100") == 60);
  CHECK(penumbra_of("\"float coneangle\" 20 \"float conedeltaangle\" 20") == 20);
  CHECK(penumbra_of("\"float coneangle\" 20 \"float conedeltaangle\" 50") == 0);
}

TEST_CASE("a spot's power is that of its cone, with the mean of its soft edge, however wide that is") {
  const auto intensity_of = [](const std::string& angles) {
    const LoadedScene loaded = load_pbrt_world("LightSource \"spot\" \"float power\" 100 " + angles);
    return std::get<SpotLight>(loaded.scene.lights.at(0).source).intensity.g;
  };
  // The whole cone and the even part in solid angles: the mean of both is what the power is spread over.
  const auto expected = [](double even_cosine, double cosine) {
    return Approx(100 / (2 * pi_double * (1 - (even_cosine + cosine) / 2)));
  };
  CHECK(intensity_of("\"float coneangle\" 60 \"float conedeltaangle\" 0") == expected(0.5, 0.5));
  CHECK(intensity_of("\"float coneangle\" 90 \"float conedeltaangle\" 30") == expected(0.5, 0));
  CHECK(intensity_of("\"float coneangle\" 60 \"float conedeltaangle\" 90") == expected(std::sqrt(0.75), 0.5));
}

}  // namespace twinray
