// SPDX-License-Identifier: Apache-2.0
#include "io/exchange/reader.h"

#include <algorithm>
#include <tuple>

#include "core/alpha_test.h"
#include "core/error.h"
#include "core/scene_textures.h"
#include "io/exchange/writer.h"
#include "io/picture/image_file.h"
#include "io/scene_file.h"
#include "tests/io/exchange/small_scene.h"
#include "tests/support/catch.h"
#include "tests/support/json.h"
#include "tests/support/meshes.h"
#include "tests/support/round_trip.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {
namespace {

const std::string sources = TWINRAY_SOURCE_DIR;
constexpr ExchangePicture frame{480, 360};

std::shared_ptr<const Image> picture(int width, int height) {
  auto image = std::make_shared<Image>();
  image->width = width;
  image->height = height;
  for (int i = 0; i < width * height; ++i) image->pixels.push_back({float(i) / 3, 0.1f, 2});
  return image;
}

/// With shading normals, few of which keep their bits when they are made unit vectors once more.
Mesh smooth_mesh() {
  Mesh mesh = icosphere_mesh(2);
  for (const Vec3& p : mesh.positions) mesh.normals.push_back(normalize(p + Vec3{0.3f, 0.2f, 0.1f}));
  mesh.normal_indices = mesh.triangles;
  return mesh;
}

/// Of each kind, with numbers of many digits: a picture that two share, and one without a mip-map.
void add_textures(Scene& scene) {
  constexpr float third = 1.0f / 3, seventh = 1.0f / 7;
  const auto shared = std::make_shared<const MipMap>(*picture(4, 2));
  const auto single = std::make_shared<const MipMap>(std::vector{*picture(5, 3)});
  const UvTransform uv{{{third, 2, seventh}, {-1, third, 0.5f}}};
  const PointTransform there{{{third, 2, 0, seventh}, {-2, third, 1, 0.5f}, {0, seventh, -third, 3}}};
  scene.textures = {
      {"red", ConstantTexture{{third, seventh, -2}}},
      {"wood", ImageTexture{shared, WrapMode::clamp, TextureFilter::trilinear, uv}},
      {"wood", ImageTexture{shared, WrapMode::black, TextureFilter::nearest, {}}},
      {"", ImageTexture{single, WrapMode::repeat, TextureFilter::bilinear, uv}},
      {"product", ScaleTexture{0, 2}},
      {"mixture", MixTexture{1, 2, 3}},
      {"board", CheckerboardTexture{0, 4, uv}},
      {"cubes", CubesTexture{0, 4}},
      {"dots", DotsTexture{4, 0, uv}},
      {"corners", BilinearTexture{{third, 0, 1}, {0, -third, 2}, {1, 1, 0}, {0, 0, seventh}, uv}},
      {"leaning", DirectionMixTexture{1, 0, {0.6f, -0.8f, 0}}},
      {"clouds", NoiseTexture{NoisePattern::fbm, {5, seventh}}},
      {"wrinkles", NoiseTexture{NoisePattern::wrinkled, {3, third}}},
      {"waves", NoiseTexture{.pattern = NoisePattern::windy}},
      {"marble", NoiseTexture{NoisePattern::marble, {2, third}, seventh, 3}},
      {"there", PlacedTexture{14, TexturePlacement::space, there}},
      {"on a plane", PlacedTexture{3, TexturePlacement::planar, there}},
      {"around", PlacedTexture{9, TexturePlacement::spherical, there}},
      {"about", PlacedTexture{9, TexturePlacement::cylindrical, there}}};
  scene.materials[0].textures = {{MaterialInput::reflectance, 1}};
  scene.materials[10].textures = {{MaterialInput::roughness_u, 5, InputMeaning::squared_roughness},
                                  {MaterialInput::reflectance, 6}};
  scene.materials[7].textures = {{MaterialInput::k, 4, InputMeaning::metal_reflectance}};
  scene.materials[1].normal_map = 2;
  scene.materials[2].bump_map = 3;
  scene.materials[3].tangent_map = 5;
  scene.materials[4].tangent_degrees = -third;
}

/// Of each texture, material and light there is, with numbers of many digits.
Scene everything() {
  Scene scene;
  constexpr float third = 1.0f / 3, seventh = 1.0f / 7;
  const Rgb color{third, seventh, 0.1f}, metal{0.2f + seventh, 1 + third, 3 + seventh};
  const Roughness facets{third, seventh};
  Principled principled;
  principled.base_color = color;
  principled.specular_ior = 1 + third;
  principled.coat_ior = 1 + seventh;
  principled.fuzz_color = color;
  principled.thin_film_weight = third, principled.thin_film_thickness = 1 + third;
  principled.thin_film_ior = 1 + seventh;
  principled.geometry_thin_walled = true;
  const SurfaceModel models[] = {Lambert{color},
                                 Mirror{color},
                                 Refraction{color, seventh, 1 + third},
                                 Glass{color, color, third, 1 + seventh},
                                 Microfacet{third, metal, metal},
                                 Dielectric{1 + third, facets, color, color, false},
                                 Dielectric{1 + third, {}, color, color, true},
                                 Conductor{metal, metal, facets, color},
                                 DiffuseTransmission{color, color},
                                 RoughDiffuse{color, third},
                                 CoatedDiffuse{color, facets, 1 + third},
                                 CoatedConductor{metal, metal, facets, color, facets, 1 + seventh},
                                 principled,
                                 Interface{},
                                 Mix{1, 3, third}};
  for (const SurfaceModel& model : models) {
    if (std::holds_alternative<Interface>(model)) scene.atmosphere = std::uint32_t(scene.materials.size());
    scene.materials.push_back({"m", model, {}});
  }
  for (Material& material : scene.materials)
    if (may_have_subsurface(material.model)) material.subsurface = {{third, seventh, 1}, -third};
  scene.materials[5].interior = {{third, seventh, 0}, 2, true, {seventh, 0, third}, -third};
  add_textures(scene);
  const Vec3 slanted = normalize({1, 2, 3});
  const Transform turned = Transform::rotation({0, 1, 0}, 33);
  scene.lights = {
      {"mesh", MeshLight{0,
                         metal,
                         EmissionSide::back,
                         picture(3, 1),
                         {{{third, 1, 2}, {3, seventh, 5}}},
                         {WrapMode::repeat, WrapMode::black},
                         TextureFilter::nearest}},
      {"sphere", SphereLight{1, metal}},
      {"point", PointLight{{third, 1, 2}, metal, {third, seventh, 2}}},
      {"spot", SpotLight{{third, 1, 2}, slanted, metal, {}, 40 + third, seventh, 1 + third}},
      {"directional", DirectionalLight{slanted, metal}},
      {"ambient", AmbientLight{slanted, metal}},
      {"sky", EnvironmentLight{picture(6, 3), MapLayout::latitude_longitude, turned, metal}},
      {"all around", GoniometricLight{{1, third, 2}, metal, picture(2, 2), MapLayout::equal_area, turned}},
      {"slide",
       ProjectionLight{
           {1, 2, third}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}, third, seventh, metal, picture(3, 2)}},
      {"sun", SunLight{slanted, metal, 0.5f + seventh}}};
  Transform place = turned;
  place.m[1][3] = 1.0 / 3;
  const SphereSet ball{"ball", {{{third, seventh, 3}, third}}};
  scene.assets = {"chair"};
  scene.bindings = {{.material = 14, .light = 0, .asset = 0},
                    {.material = 7, .light = 1},
                    {.material = 12, .alpha = 5, .asset = 0}};
  scene.geometry =
      std::make_shared<const Geometry>(cut_out({smooth_mesh(), ball, box_mesh()}, scene.bindings,
                                               scene.textures, Instancing{{{2, 1}}, {{0, place}, {0, {}}}}));
  scene.camera.position = {third, 1, 5};
  return scene;
}

}  // namespace

TEST_CASE("a scene in exchange form is read with all its bits, whatever is in it") {
  const Scene scene = everything();
  const RoundTrip trip = round_trip(scene, "a.json");
  CHECK(trip.warnings.empty());
  CHECK(exchange_json(trip.scene, "a.json", frame) == trip.text);
  const GeometryDifference apart = difference(scene, trip.scene);
  CHECK(apart.fault == "");
  CHECK(apart.positions + apart.normals == 0);
  REQUIRE(trip.scene.geometry->instances().size() == 2);
  const Transform &place = scene.geometry->instances()[0].to_world,
                  &read_place = trip.scene.geometry->instances()[0].to_world;
  CHECK(std::equal(&place.m[0][0], &place.m[0][0] + 12, &read_place.m[0][0]));
  for (const std::size_t light : {6u, 7u, 8u})
    CHECK(scene.lights[light].name == trip.scene.lights[light].name);
  const auto& lamp = std::get<MeshLight>(trip.scene.lights[0].source);
  CHECK(lamp.picture->pixels == picture(3, 1)->pixels);
  CHECK(lamp.uv == std::get<MeshLight>(scene.lights[0].source).uv);
  CHECK(lamp.wrap == Wrap{WrapMode::repeat, WrapMode::black});
  CHECK(lamp.filter == TextureFilter::nearest);
  CHECK(trip.scene.assets == scene.assets);
  const auto maps = [](const Material& m) {
    return std::tuple(m.normal_map, m.bump_map, m.tangent_map, m.tangent_degrees);
  };
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    CHECK(maps(trip.scene.materials[i]) == maps(scene.materials[i]));
    CHECK(trip.scene.materials[i].interior == scene.materials[i].interior);
    CHECK(trip.scene.materials[i].subsurface == scene.materials[i].subsurface);
  }
  CHECK(trip.scene.atmosphere == scene.atmosphere);
  const auto& sky = std::get<EnvironmentLight>(scene.lights[6].source);
  const auto& read_sky = std::get<EnvironmentLight>(trip.scene.lights[6].source);
  CHECK(read_sky.map->pixels == sky.map->pixels);
  CHECK(std::equal(&sky.rotation.m[0][0], &sky.rotation.m[0][0] + 12, &read_sky.rotation.m[0][0]));
}

TEST_CASE("our own scenes come back from exchange form, with the camera's bits at their resolution") {
  for (const char* name : {"box.dae", "cornell-bunny.dae", "spheres.dae", "lights.dae", "still-life.pbrt",
                           "pawns.pbrt", "layers.pbrt", "films.pbrt", "table.gltf", "blocks.obj"}) {
    INFO(name);
    const Scene scene = load_scene(sources + "/scenes/" + name).scene;
    const RoundTrip trip = round_trip(scene, "a.json");
    CHECK(exchange_json(trip.scene, "a.json", frame) == trip.text);
    const GeometryDifference apart = difference(scene, trip.scene);
    CHECK(apart.fault == "");
    CHECK(apart.positions == 0);
    CHECK(apart.normals == 0);
    const Camera written = fit_frame(scene.camera, frame.width, frame.height);
    const Camera read = fit_frame(trip.scene.camera, frame.width, frame.height);
    CHECK(read.tan_half_width == written.tan_half_width);
    CHECK(read.tan_half_height == written.tan_half_height);
    // Other pictures show the same frame, widened.
    const Camera square = fit_frame(trip.scene.camera, 100, 100);
    CHECK(square.tan_half_width == Approx(square.tan_half_height));
  }
}

TEST_CASE("a camera of oblong pixels keeps its frame") {
  Scene scene = everything();
  scene.camera.is_stretched = true;
  scene.camera.tan_half_width = 0.3f;
  scene.camera.tan_half_height = 0.7f;
  const Camera read = round_trip(scene, "a.json").scene.camera;
  CHECK(read.is_stretched);
  CHECK(read.tan_half_width == 0.3f);
  CHECK(read.tan_half_height == 0.7f);
}

TEST_CASE("the picture's size is that of the file") {
  const LoadedScene loaded = read_exchange(small().dump(), "a.json", {}, {});
  REQUIRE(loaded.defaults.resolution);
  CHECK(loaded.defaults.resolution->width == 480);
  CHECK(loaded.defaults.resolution->height == 360);
}

TEST_CASE("textures come back from exchange form with all that they are made of") {
  Scene scene = everything();
  RoundTrip trip = round_trip(scene, "a.json");
  REQUIRE(trip.scene.textures.size() == scene.textures.size());
  for (std::uint32_t i = 0; i < scene.textures.size(); ++i)
    for (const float u : {-0.3f, 0.1f, 0.4f, 1.2f}) {
      CAPTURE(i, u);
      const TexturePoint at{.uv = {u, 0.7f - u},
                            .footprint = 0.4f,
                            .position = {3 * u, 1 - u, u * u},
                            .normal = {0.6f, u > 0 ? 0.8f : -0.8f, 0},
                            .width = 0.02f};
      CHECK(evaluate(trip.scene.textures, i, at) == evaluate(scene.textures, i, at));
    }
  const auto image = [&](std::size_t i) {
    return std::get<ImageTexture>(trip.scene.textures[i].model).image;
  };
  CHECK(image(1) == image(2));
  CHECK(image(1)->levels() == 3);
  CHECK(image(3)->levels() == 1);
  // What --texture-filter makes of them is the same, too: it leaves a picture without a mip-map as it is.
  set_filter(trip.scene.textures, TextureFilter::stochastic);
  CHECK(std::get<ImageTexture>(trip.scene.textures[3].model).filter == TextureFilter::bilinear);
}

TEST_CASE("a picture that an exchange form names and that is not there is shown magenta, and named") {
  nlohmann::json json = small();
  const nlohmann::json uv = {{1, 0, 0}, {0, 1, 0}};
  json["version"] = 3;
  json["textures"] = {{{"name", "wood"},
                       {"type", "image"},
                       {"wrap", "repeat"},
                       {"filter", "stochastic"},
                       {"uv", uv},
                       {"file", "no-such.exr"}}};
  const LoadedScene loaded = read_exchange(json.dump(), "a.json", {}, {});
  CHECK(evaluate(loaded.scene.textures, 0, {}) == Rgb{1, 0, 1});
  REQUIRE(loaded.warnings.size() == 1);
  CHECK(loaded.warnings[0].text().starts_with("a.json: textures[0]: no-such.exr: "));
  CHECK(loaded.warnings[0].text().ends_with("; it is shown magenta"));
  LoadOptions strict;
  strict.strict = true;
  CHECK_THROWS_WITH(read_exchange(json.dump(), "a.json", strict, {}),
                    Catch::Matchers::StartsWith("a.json: textures[0]: no-such.exr: "));
}

TEST_CASE("a picture of an exchange form has the role and the smaller copies that each texture asks for") {
  const TemporaryFolder folder;
  write_png(folder.file("grey.png"), ByteImage{2, 1, {188, 188, 188, 188, 188, 188}});
  nlohmann::json json = small();
  const nlohmann::json uv = {{1, 0, 0}, {0, 1, 0}};
  const nlohmann::json image = {{"name", ""},           {"type", "image"}, {"wrap", "repeat"},
                                {"filter", "bilinear"}, {"uv", uv},        {"file", "grey.png"}};
  json["textures"] = {image, image, image, image};
  json["textures"][1]["role"] = "color";
  json["textures"][2]["role"] = "data";
  json["textures"][3]["mip_map"] = false;
  const LoadedScene loaded = read_exchange(json.dump(), folder.file("a.json"), {}, {});
  const auto value = [&](std::uint32_t i) { return evaluate(loaded.scene.textures, i, {}).r; };
  CHECK(value(0) == Approx(0.5f).margin(0.005));
  CHECK(value(1) == value(0));
  CHECK(value(2) == Approx(188.0f / 255));
  const auto picture = [&](std::size_t i) {
    return std::get<ImageTexture>(loaded.scene.textures[i].model).image;
  };
  CHECK(picture(0) == picture(1));
  CHECK(picture(0)->levels() == 2);
  CHECK(picture(3)->levels() == 1);
}

TEST_CASE("what is wrong in an exchange form is said with its entry and what would be valid") {
  CHECK(error_of(small()) == "");
  const auto wrong = [](const char* pointer, const nlohmann::json& value) {
    nlohmann::json json = small();
    json[nlohmann::json::json_pointer(pointer)] = value;
    return error_of(json);
  };
  const auto without = [](const char* list, const char* key) {
    nlohmann::json json = small();
    json[list][0].erase(key);
    return error_of(json);
  };
  CHECK(wrong("/format", "gltf") ==
        "a.json: \"format\" is not \"twinray scene\": this is another kind of JSON file");
  CHECK(wrong("/version", 5) == "a.json: \"version\" is 5; versions 1 to 4 are known");
  CHECK(wrong("/materials/1/type", "gold")
            .starts_with("a.json: materials[1]: \"type\" is \"gold\"; valid are lambert, mirror,"));
  CHECK(wrong("/materials/1/eta", {1, 2}) == "a.json: materials[1]: \"eta\" has 2 elements; it must have 3");
  CHECK(wrong("/materials/1", {{"name", ""}, {"type", "interface"}}) ==
        "a.json: shape 0 emits light, but its material 1 is no surface: an interface emits none");
  CHECK(wrong("/materials/1/eta/2", -1) ==
        "a.json: materials[1]: \"eta\" is -1; it must be a float, and not negative");
  CHECK(wrong("/materials/1/k/0", 1e300) ==
        "a.json: materials[1]: \"k\" is 1e+300; it must be a float, and not negative");
  CHECK(wrong("/materials/1/alpha/0", 1.5) ==
        "a.json: materials[1]: \"alpha\" is 1.5; it must be from 0 to 1");
  CHECK(wrong("/materials/1/alpha/0", "wide") == "a.json: materials[1]: \"alpha\" must be a number");
  CHECK(without("materials", "reflectance") == "a.json: materials[0]: \"reflectance\" is missing");
  CHECK(wrong("/materials/1/interior", {{"absorption", {0, 0, 0}}, {"priority", 0}, {"anisotropy", 1}}) ==
        "a.json: materials[1]: interior: \"anisotropy\" is 1; it must be from -0.99 to 0.99");
  const nlohmann::json below{{"radius", {1, 1, 1}}, {"anisotropy", 0}};
  CHECK(wrong("/materials/1/subsurface", below) ==
        "a.json: materials[1]: \"subsurface\" belongs to a \"coated_diffuse\" or an \"openpbr\" that is not "
        "thin-walled");
  const auto wrong_below = [&](const char* key, const nlohmann::json& value) {
    nlohmann::json changed = below;
    changed[key] = value;
    return wrong("/materials/0", {{"name", "m"},
                                  {"type", "coated_diffuse"},
                                  {"reflectance", {1, 1, 1}},
                                  {"alpha", {0, 0}},
                                  {"ior", 1.5},
                                  {"subsurface", changed}});
  };
  CHECK(wrong_below("radius", {1, 0, 1}).starts_with("a.json: materials[0]: subsurface: \"radius\" is 0; "));
  CHECK(wrong_below("anisotropy", 1) ==
        "a.json: materials[0]: subsurface: \"anisotropy\" is 1; it must be from -0.99 to 0.99");
  const auto wrong_grid = [&](const nlohmann::json& size, const nlohmann::json& rows, const char* file) {
    return wrong("/densities", {{{"size", size}, {"to_unit", rows}, {"file", file}}});
  };
  const nlohmann::json rows{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}};
  CHECK(wrong_grid({0, 1, 1}, rows, "a.exr").starts_with("a.json: densities[0]: \"size\" is 0; "));
  CHECK(wrong_grid({1, 1}, rows, "a.exr").starts_with("a.json: densities[0]: \"size\" has 2 elements"));
  CHECK(wrong_grid({1, 1, 1}, rows, "none.exr").find("none.exr") != std::string::npos);
  CHECK(wrong("/materials/1/interior",
              {{"absorption", {0, 0, 0}}, {"priority", 0}, {"is_clear", true}, {"density", 3}})
            .find("material 1") != std::string::npos);
  CHECK(wrong("/atmosphere", 9) == "a.json: the atmosphere is that of material 9; there are 2");
  CHECK(wrong("/atmosphere", 0) == "a.json: the atmosphere is that of material 0, which is not an interface");
  CHECK(wrong("/materials/0", 7) == "a.json: materials[0]: it must be an object");
  CHECK(wrong("/lights", 7) == "a.json: \"lights\" must be a list");
  CHECK(wrong("/lights/0/shape", -1) ==
        "a.json: lights[0]: \"shape\" is -1; it must be a whole number from 0 to 2147483647");
  CHECK(wrong("/lights/0/shape", 4) == "a.json: light 0 names shape 4, which is not a set of one sphere");
  CHECK(wrong("/lights/1/direction", {0, 0, 2}) ==
        "a.json: lights[1]: \"direction\" must be a vector of length 1");
  CHECK(wrong("/lights/1/attenuation/linear", -2) ==
        "a.json: lights[1]: attenuation: \"linear\" is -2; it must be a float, and not negative");
  CHECK(wrong("/shapes/0/type", "cube") ==
        "a.json: shapes[0]: \"type\" is \"cube\"; valid are mesh, spheres");
  CHECK(wrong("/shapes/0/spheres/0", {1, 2}) == "a.json: shapes[0]: \"spheres\" must be lists of 4 numbers");
  CHECK(wrong("/shapes/0/material", 2) == "a.json: shape 0 names material 2; there are 2");
  const std::string one_sided = "a.json: shapes[0]: its \"light\" must be the one whose \"shape\" it is";
  CHECK(wrong("/shapes/0/light", 1) == one_sided);
  CHECK(without("shapes", "light") == one_sided);
  CHECK(wrong("/shapes/0/light", 2) == "a.json: shape 0 names light 2; there are 2");
  CHECK(wrong("/shapes/0/prototype", 1) ==
        "a.json: shapes[0]: \"prototype\" is 1; the shapes of prototypes follow each other, from 0 on");
  CHECK(wrong("/camera/type", "pinhole")
            .starts_with("a.json: camera: \"type\" is \"pinhole\"; valid are perspective,"));
  CHECK(wrong("/camera/up", {1, 0, 0}) ==
        "a.json: camera: \"right\", \"up\" and \"forward\" must be at right angles");
  CHECK(wrong("/camera/tan_half_width", 0) ==
        "a.json: camera: \"tan_half_width\" is 0; it must be a float above 0");
  for (const double far : {0.5, 1.0}) {
    nlohmann::json json = small();
    json["camera"].update({{"clip_near", 1}, {"clip_far", far}});
    CHECK(error_of(json) == "a.json: camera: \"clip_far\" must lie beyond \"clip_near\"");
  }
  CHECK(wrong("/camera/clip_along", "x") ==
        "a.json: camera: \"clip_along\" is \"x\"; valid are forward, ray");
  CHECK(wrong("/camera/aperture", {{"blades", 2}, {"turns", 0}}) ==
        "a.json: camera: aperture: \"blades\" is 2; it must be a whole number from 3 to 1000");
  CHECK(wrong("/resolution/1", 0) ==
        "a.json: \"resolution\" is 0; it must be a whole number from 1 to 65536");
  CHECK(wrong("/instances", {{{"prototype", 0}, {"to_world", {1, 2}}}}) ==
        "a.json: instances[0]: \"to_world\" has 2 elements; it must have 3");
}

TEST_CASE("files of an exchange form lie beside it") {
  nlohmann::json json = small();
  json["shapes"][0] = {{"name", "a"}, {"type", "mesh"}, {"file", "../a.ply"}, {"material", 0}};
  json["lights"].erase(0);
  CHECK(error_of(json) ==
        "a.json: shapes[0]: \"file\" is \"../a.ply\"; it must be the name of a file beside this one");
  json["shapes"][0]["file"] = std::string("a.ply\0b", 7);
  CHECK(error_of(json).starts_with("a.json: shapes[0]: \"file\" is \"a.ply"));
  json["shapes"][0]["file"] = "a.ply";
  CHECK(error_of(json) == "a.json: shapes[0]: a.ply: there is no such file");
  for (const char* text : {"", "{", "[[[", "nul"}) {
    INFO(text);
    CHECK_THROWS_WITH(read_exchange(text, "a.json", {}, {}),
                      Catch::Matchers::StartsWith("a.json: this is no JSON: "));
  }
}

}  // namespace twinray::test
