// SPDX-License-Identifier: Apache-2.0
// Scenes written as glTF are read again: what comes back is what was there, as far as the format has it.
#include "io/gltf/writer.h"

#include <algorithm>
#include <cmath>

#include "core/alpha_test.h"
#include "io/output_file.h"
#include "io/scene_file.h"
#include "io/scene_writer.h"
#include "tests/io/gltf/written.h"
#include "tests/support/catch.h"
#include "tests/support/round_trip.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {
namespace {

constexpr float rounding = 1e-6f;
/// The reader shows what emits first, where it stores the rest once.
const LoadOptions copies{.instances = InstanceUse::copy};
/// Of 1 - v, there and back.
constexpr float v_rounding = 0x1p-23f;

LoadedScene load(const std::string& name) {
  return load_scene(std::string(TWINRAY_SOURCE_DIR) + "/scenes/" + name);
}

/// The largest distance of two textures' values at points of a grid.
float apart(const Scene& a, std::uint32_t texture, const Scene& b, std::uint32_t other) {
  float most = 0;
  for (int i = 0; i < 81; ++i) {
    const TexturePoint at{.uv = {0.37f * float(i % 9) - 1, 0.29f * float(i / 9) - 1}, .is_smooth = true};
    const Rgb x = evaluate(a.textures, texture, at), y = evaluate(b.textures, other, at);
    most = std::max({most, std::fabs(x.r - y.r), std::fabs(x.g - y.g), std::fabs(x.b - y.b)});
  }
  return most;
}
/// What a byte of sRGB is off, where it is steepest.
constexpr float byte_rounding = 0.5f / 255 * 2.3f;

std::uint32_t texture_of(const RoundTrip& trip, MaterialInput input) {
  for (const TextureUse& use : only_material(trip).textures)
    if (use.input == input) return use.texture;
  return no_texture;
}

}  // namespace

TEST_CASE(
    "written gltf: the shapes of this project's scenes come back as they were, in one file or several") {
  for (const char* name : {"box.dae", "cornell-bunny.dae", "table.gltf", "blocks.obj"}) {
    INFO(name);
    const Scene scene = load(name).scene;
    const RoundTrip text = round_trip(scene, "a.gltf", copies), binary = round_trip(scene, "a.glb", copies);
    const GeometryDifference apart = difference(scene, text.scene);
    CHECK(apart.fault == "");
    CHECK(apart.positions == 0);
    CHECK(apart.uvs <= v_rounding);  // The reader leaves those out that no texture needs.
    if (std::string(name) == "table.gltf") CHECK_FALSE(apart.has_lost_uvs);
    CHECK(apart.normals <= 1.2e-7f);
    const GeometryDifference other = difference(text.scene, binary.scene);
    CHECK(other.fault == "");
    CHECK(other.positions + other.normals + other.uvs == 0);
    CHECK(text.warnings == binary.warnings);
    CHECK(first_difference(surfaces(text.scene), surfaces(binary.scene), 0) == "");
    CHECK(text.scene.textures.size() == binary.scene.textures.size());
    CHECK(difference(scene.camera, text.scene.camera) <= 4 * rounding);
    CHECK(difference(text.scene.camera, binary.scene.camera) == 0);
  }
}

TEST_CASE("written gltf: what was read from a file of this format comes back") {
  const Scene scene = load("table.gltf").scene;
  const RoundTrip trip = round_trip(scene, "a.gltf", copies);
  CHECK(trip.warnings.empty());
  CHECK(first_difference(surfaces(scene), surfaces(trip.scene), 2e-6) == "");
  CHECK(first_difference(free_lights(scene), free_lights(trip.scene), 2e-6) == "");
}

TEST_CASE("written gltf: each property of a surface that the format has comes back") {
  Principled plain;
  plain.base_color = {0.1f, 0.2f, 0.3f};
  plain.base_metalness = 0.4f;
  plain.specular_roughness = 0.55f;
  plain.coat_ior = 1.5f;
  Principled dull = plain;
  dull.specular_ior = 1.7f, dull.specular_weight = 0.5f, dull.specular_color = {0.5f, 0.75f, 1};
  Principled brushed = plain;
  brushed.base_metalness = 1, brushed.specular_roughness_anisotropy = 0.5f;
  Principled layered = plain;
  layered.coat_weight = 0.8f, layered.coat_roughness = 0.3f, layered.coat_darkening = 0;
  layered.fuzz_weight = 0.5f, layered.fuzz_color = {1, 0.25f, 0.5f}, layered.fuzz_roughness = 0.7f;
  Principled filmed = plain;
  filmed.thin_film_weight = 0.8f, filmed.thin_film_thickness = 1.25f, filmed.thin_film_ior = 1.7f;
  Principled clear = plain;
  clear.base_metalness = 0, clear.transmission_weight = 0.9f, clear.transmission_color = clear.base_color;
  Principled sheet = clear;
  sheet.geometry_thin_walled = true;
  for (const Principled& model : {plain, dull, brushed, layered, filmed, clear, sheet}) {
    Scene scene = scene_of(triangle(), model);
    if (lets_light_in(model)) scene.materials[0].interior.absorption = {0.5f, 2, 0};
    const RoundTrip trip = round_trip(scene, "a.gltf");
    CHECK(trip.warnings.empty());
    auto wanted = surfaces(scene), read = surfaces(trip.scene);
    for (auto* list : {&wanted, &read}) {  // What nothing shows.
      if (model.coat_weight == 0)
        (*list)[0]["material"]["coat_darkening"] = 0, (*list)[0]["material"]["coat_ior"] = 0;
      if (model.fuzz_weight == 0) (*list)[0]["material"]["fuzz_roughness"] = 0;
      if (model.thin_film_weight == 0)
        (*list)[0]["material"]["thin_film_thickness"] = 0, (*list)[0]["material"]["thin_film_ior"] = 0;
      if (model.transmission_weight == 0) (*list)[0]["material"]["geometry_thin_walled"] = false;
    }
    CHECK(first_difference(wanted, read, 1e-5) == "");
  }
}

TEST_CASE("written gltf: other materials are surfaces that reflect alike, and are named") {
  const auto comes_back = [](const SurfaceModel& model, const std::vector<std::string>& warnings) {
    const RoundTrip trip = round_trip(scene_of(triangle(), model), "a.gltf");
    CHECK(trip.warnings == warnings);
    return std::get<Principled>(only_material(trip).model);
  };
  const Principled diffuse = comes_back(Lambert{{0.5f, 0.25f, 0.125f}}, {});
  CHECK(diffuse.base_color == Rgb{0.5f, 0.25f, 0.125f});
  CHECK(diffuse.specular_weight == 0);
  const Principled glass = comes_back(Dielectric{1.25f, {0.25f, 0.25f}}, {});
  CHECK(glass.transmission_weight == 1);
  CHECK(glass.specular_ior == 1.25f);
  CHECK(glass.specular_roughness == 0.5f);
  CHECK_FALSE(glass.geometry_thin_walled);
  CHECK(comes_back(Dielectric{.is_thin = true}, {}).geometry_thin_walled);
  const Principled metal =
      comes_back(Conductor{{1, 1, 1}, {2, 0, 1}, {0.25f, 0.25f}},
                 {"a material of the type conductor is written as a metal of its color"});
  CHECK(metal.base_metalness == 1);
  CHECK(metal.base_color.r == Approx(0.5));  // k^2 / (4 + k^2)
  CHECK(metal.base_color.g == 0);
  CHECK(metal.specular_roughness == 0.5f);
  Principled coated{.coat_weight = 1, .coat_ior = 1.5f, .coat_darkening = 1};
  comes_back(coated,
             {"what the coat reflects back to the base, which darkens it, of a material is left out"});
  coated.coat_darkening = 0, coated.coat_ior = 1.25f;
  comes_back(coated, {"the coat's index, which is 1.5 there, of a material is left out"});
  comes_back(CoatedDiffuse{}, {"a material of the type coated_diffuse is written as a glossy surface"});
  comes_back(DiffuseTransmission{},
             {"a material of the type diffuse_transmission is written as a diffuse surface, through which no "
              "light goes"});
  CHECK(
      comes_back(CoatedConductor{},
                 {"a material of the type coated_conductor is written as a metal of its color below a clear "
                  "coat"})
          .coat_weight == 1);
  Principled tinted;
  tinted.base_metalness = 1, tinted.specular_color = {1, 0.5f, 0.5f};
  comes_back(tinted, {"the metal's specular color of a material is left out"});
  Scene mixed = scene_of(triangle(), Lambert{{0.5f, 0.5f, 0.5f}});
  mixed.materials.push_back({"b", Lambert{{0.25f, 0.25f, 0.25f}}});
  mixed.materials.push_back({"mix", Mix{0, 1, 0.75f}});
  mixed.bindings[0].material = 2;
  const RoundTrip trip = round_trip(mixed, "a.gltf");
  CHECK(trip.warnings == std::vector<std::string>{"a mixture of materials is the one that it has more of"});
  CHECK(std::get<Principled>(only_material(trip).model).base_color.r == 0.25f);
}

TEST_CASE("written gltf: emitters and lights come back with every bit of their strength") {
  Scene scene = scene_of(triangle(), Lambert{});
  const Vec3 along = normalize(Vec3{1, -2, 0.5f});
  for (const EmissionSide side : {EmissionSide::front, EmissionSide::back, EmissionSide::both}) {
    scene.bindings[0].light = 0;
    scene.lights = {{"lamp", MeshLight{0, {1.1f, 2.2f, 3e7f}, side}},
                    {"a", PointLight{{1.1f, 2, 3}, {1.7f, 0.8f, 5.7f}}},
                    {"b", DirectionalLight{along, {0.1f, 0.2f, 0.3f}}},
                    {"c", SpotLight{{100.1f, 2, 3}, along, {4, 5, 6}, {}, 35.5f, 0, 4.25f}}};
    const RoundTrip trip = round_trip(scene, "a.glb");
    CHECK(trip.warnings.empty());
    const auto light = std::find_if(trip.scene.lights.begin(), trip.scene.lights.end(), [](const Light& l) {
      return std::holds_alternative<MeshLight>(l.source);
    });
    REQUIRE(light != trip.scene.lights.end());
    const auto& mesh = std::get<MeshLight>(light->source);
    CHECK(mesh.radiance == Rgb{1.1f, 2.2f, 3e7f});
    CHECK(mesh.side == (side == EmissionSide::both ? side : EmissionSide::front));
    CHECK((trip.scene.geometry->facet(0, 0).normal.z < 0) == (side == EmissionSide::back));
    CHECK(first_difference(free_lights(scene), free_lights(trip.scene), 1e-6) == "");
    for (const Light& read : trip.scene.lights)
      if (const auto* point = std::get_if<PointLight>(&read.source))
        CHECK(point->intensity == Rgb{1.7f, 0.8f, 5.7f});  // Divided by 5.7 they would lose bits.
  }
}

TEST_CASE("written gltf: a bright picture that emits is divided by what it has at most") {
  Scene scene = scene_of(triangle(), Lambert{});
  const auto glow = std::make_shared<Image>(2, 1);
  glow->pixels = {{0, 8, 4}, {2, 1, 0.5f}};
  scene.bindings[0].light = 0;
  scene.lights = {{"lamp", MeshLight{0, {3, 3, 3}, EmissionSide::front, glow}}};
  const RoundTrip trip = round_trip(scene, "a.gltf");
  CHECK(trip.warnings.empty());
  const auto& light = std::get<MeshLight>(trip.scene.lights[0].source);
  REQUIRE(light.picture);
  for (std::size_t i = 0; i < 2; ++i) {
    const Rgb read = light.radiance * light.picture->pixels[i], wanted = glow->pixels[i] * 3;
    CHECK(read.r == Approx(wanted.r).margin(24 * byte_rounding));
    CHECK(read.g == Approx(wanted.g).margin(24 * byte_rounding));
  }
  auto& placed = std::get<MeshLight>(scene.lights[0].source);
  placed.uv = {{{2, 0, 0.25f}, {0, 0.5f, 0.125f}}}, placed.wrap = {WrapMode::repeat, WrapMode::clamp};
  placed.filter = TextureFilter::nearest;
  const auto again = std::get<MeshLight>(round_trip(scene, "a.gltf").scene.lights[0].source);
  for (int i = 0; i < 6; ++i)
    CHECK(again.uv.m[i / 3][i % 3] == Approx(placed.uv.m[i / 3][i % 3]).margin(1e-6));
  CHECK(again.wrap == placed.wrap);
  CHECK(again.filter == TextureFilter::nearest);
}

TEST_CASE("written gltf: a picture that emits has no light below 0, which is told") {
  Scene scene = scene_of(triangle(), Lambert{{0, 0, 0}});
  auto picture = std::make_shared<Image>(2, 1);
  picture->pixels = {{1, 0.5f, 0.25f}, {-0.5f, 1, 0}};
  scene.lights = {{"panel", MeshLight{0, {1, 1, 1}, EmissionSide::front, picture}}};
  scene.bindings[0].light = 0;
  CHECK(round_trip(scene, "a.gltf").warnings ==
        std::vector<std::string>{
            "a picture has colors below 0, which are 0, as colors of vertices in unlit surfaces"});
}

TEST_CASE("written gltf: lights and cameras that the format has not are named") {
  Scene scene = scene_of(SphereSet{"ball", {{{1, 2, 3}, 0.5f}}}, Lambert{});
  const auto sky = std::make_shared<Image>(1, 1);
  sky->pixels = {{1, 1, 1}};
  scene.bindings[0].light = 0;
  scene.lights = {{"", SphereLight{0, {1, 2, 3}}},
                  {"", EnvironmentLight{sky}},
                  {"", EnvironmentLight{sky}},
                  {"", AmbientLight{}},
                  {"", SunLight{{0, -1, 0}, {4, 5, 6}}}};
  scene.camera.lens_radius = 0.5f;
  scene.camera.frame_center = {0.25f, 0};
  scene.camera.right = -scene.camera.right;
  const RoundTrip trip = round_trip(scene, "a.gltf");
  CHECK(trip.warnings == std::vector<std::string>{
                             "the camera's lens is a pinhole", "the shift of the camera's frame is left out",
                             "the camera shows the scene mirrored, which readers may not follow",
                             "a sphere light is a mesh that emits", "2 environment lights: each is left out",
                             "an ambient light is left out", "a sun light is a direction, without a disc",
                             "a sphere is a mesh of 256 edges around"});
  CHECK(trip.scene.camera.right.x == Approx(scene.camera.right.x));
  REQUIRE(trip.scene.lights.size() == 2);
  const auto& box = trip.scene.geometry->bounds();
  CHECK(box.lower.x == Approx(0.5));
  CHECK(box.upper.z == Approx(3.5));
}

TEST_CASE("written gltf: textures come back as they lie, each in its channel") {
  Principled model;
  Scene scene = scene_of(triangle(), model);
  const UvTransform turned{{{1.5f, -0.5f, 0.25f}, {1, 0.75f, 0.125f}}};  // Turned, and scaled by two numbers.
  constexpr Wrap beside{WrapMode::clamp, WrapMode::repeat};
  scene.textures = {{"colors", ImageTexture{picture(), beside, TextureFilter::bilinear, turned}},
                    {"points", ImageTexture{picture(), WrapMode::repeat, TextureFilter::nearest, {}}},
                    {"twice", ScaleTexture{1, 1}}};
  scene.materials[0].textures = {
      {MaterialInput::reflectance, 0}, {MaterialInput::roughness, 1}, {MaterialInput::base_metalness, 2}};
  for (const char* name : {"a.gltf", "a.glb"}) {
    const RoundTrip trip = round_trip(scene, name);
    CHECK(trip.warnings.empty());
    const std::uint32_t color = texture_of(trip, MaterialInput::reflectance);
    REQUIRE(color != no_texture);
    const auto& image = std::get<ImageTexture>(trip.scene.textures[color].model);
    CHECK(image.wrap == beside);
    for (int i = 0; i < 6; ++i)
      CHECK(image.uv.m[i / 3][i % 3] == Approx(turned.m[i / 3][i % 3]).margin(1e-6));
    std::get<ImageTexture>(trip.scene.textures[color].model);
    scene.textures[0].model = ImageTexture{picture(), beside, image.filter, turned};
    CHECK(apart(scene, 0, trip.scene, color) <= byte_rounding);
    const auto red = [&](std::uint32_t texture, Vec2 uv) {
      return evaluate(trip.scene.textures, texture, {.uv = uv, .is_smooth = true}).r;
    };
    const std::uint32_t rough = texture_of(trip, MaterialInput::roughness),
                        metal = texture_of(trip, MaterialInput::base_metalness);
    REQUIRE(rough != no_texture);
    REQUIRE(metal != no_texture);
    for (const Vec2 uv : {Vec2{0.1f, 0.9f}, {0.9f, 0.9f}, {0.4f, 0.2f}}) {
      const float wanted = evaluate(scene.textures, 1, {.uv = uv}).r;
      CHECK(red(rough, uv) == Approx(wanted).margin(0.5 / 255 + 1e-6));
      CHECK(red(metal, uv) == Approx(wanted * wanted).margin(0.5 / 255 + 1e-6));
    }
  }
}

TEST_CASE("written gltf: holes come back, those below a limit and those of a chance") {
  const auto alpha_of = [](const std::vector<Texture>& textures, std::uint32_t alpha) {
    Scene scene = scene_of(triangle(), Lambert{});
    scene.textures = textures;
    scene.bindings[0].alpha = alpha;
    scene.geometry =
        std::make_shared<const Geometry>(cut_out({triangle()}, scene.bindings, scene.textures, {}));
    const RoundTrip trip = round_trip(scene, "a.gltf");
    CHECK(trip.warnings.empty());
    CHECK_FALSE(trip.scene.geometry->is_opaque(0));
    for (const Vec2 uv : {Vec2{0.1f, 0.9f}, {0.6f, 0.9f}, {0.4f, 0.2f}, {0.9f, 0.2f}})
      CHECK(alpha_at(trip.scene.textures, trip.scene.bindings[0].alpha, {.uv = uv}) ==
            Approx(alpha_at(textures, alpha, {.uv = uv})).margin(0.5 / 255 + 1e-6));
    return trip.text;
  };
  const Texture points{"", ImageTexture{picture(), WrapMode::repeat, TextureFilter::nearest, {}}};
  CHECK(alpha_of({points}, 0).find("BLEND") != std::string::npos);
  CHECK(alpha_of({{"", ConstantTexture{{0.25f, 0.25f, 0.25f}}}}, 0).find("BLEND") != std::string::npos);
  constexpr float limit = 0.35f, steep = 4096;
  CHECK(alpha_of({points,
                  {"", ConstantTexture{{1 - steep * limit, 0, 0}}},
                  {"", ConstantTexture{{1 - steep * limit + steep, 0, 0}}},
                  {"", MixTexture{1, 2, 0}}},
                 3)
            .find("MASK") != std::string::npos);
}

TEST_CASE("written gltf: spheres of one material share a mesh, and so do instances") {
  Scene scene = scene_of(SphereSet{"balls", {{{1, 2, 3}, 0.5f}, {{4, 5, 6}, 2}}}, Lambert{});
  scene.geometry = std::make_shared<const Geometry>(
      std::vector<Shape>{scene.geometry->shapes()[0], SphereSet{"ball", {{{0, 0, 0}, 1}}}});
  scene.bindings.resize(2);
  const RoundTrip balls = round_trip(scene, "a.gltf");
  CHECK(balls.scene.geometry->shapes().size() == 1);
  CHECK(balls.scene.geometry->instances().size() == 3);
  CHECK(balls.scene.geometry->bounds().upper.z == Approx(8));
  Transform place = Transform::translation(1, 2, 3) * Transform::rotation({1, 1, 0}, 30);
  scene = scene_of(triangle(), Lambert{});
  scene.geometry = std::make_shared<const Geometry>(std::vector<Shape>{triangle()}, nullptr,
                                                    Instancing{{{0, 1}}, {{0, place}, {0, {}}}});
  const RoundTrip trip = round_trip(scene, "a.gltf");
  CHECK(trip.warnings.empty());
  REQUIRE(trip.scene.geometry->instances().size() == 2);
  const Transform& read = trip.scene.geometry->instances()[0].to_world;
  CHECK(std::equal(&read.m[0][0], &read.m[0][0] + 12, &place.m[0][0]));
  CHECK(difference(scene, trip.scene).positions == 0);
}

TEST_CASE("written gltf: a normal map has the slopes that it had, also where it lies mirrored") {
  Mesh both = triangle();
  both.positions.push_back({1, 1, 0});
  both.uvs.push_back({0.5f, 0.125f});  // The second triangle's coordinates run the other way round.
  both.triangles.push_back({1, 3, 2});
  both.uv_indices = both.triangles;
  Scene scene = scene_of(both, Principled{});
  scene.textures = {{"", ImageTexture{picture(), WrapMode::repeat, TextureFilter::nearest, {}}}};
  scene.materials[0].normal_map = 0;
  const auto mapped = [&] {
    const RoundTrip trip = round_trip(scene, "a.gltf");
    CHECK(trip.warnings.empty());
    int shapes = 0;
    for (const ShapeBinding& binding : trip.scene.bindings)
      if (const auto map = trip.scene.materials[binding.material].normal_map; map != no_texture) {
        CHECK(apart(scene, 0, trip.scene, map) <= 0.5f / 255 + rounding);
        ++shapes;
      }
    return shapes;
  };
  CHECK(mapped() == 2);
  const std::vector<Instance> instances{{0, {}},
                                        {0, Transform::translation(0, 0, 3) * Transform::scaling(-1, 1, 1)}};
  const auto place = [&](std::vector<Shape> shapes, const ShapeRange& prototype) {
    scene.geometry =
        std::make_shared<const Geometry>(std::move(shapes), nullptr, Instancing{{prototype}, instances});
  };
  place({both}, {0, 1});
  CHECK(mapped() == 4);
  // The second shape alone has a map.
  place({triangle(), both}, {0, 2});
  scene.materials.push_back({"", Principled{}});
  scene.bindings = {{1}, {0}};
  CHECK(mapped() == 4);
}

TEST_CASE("written gltf: files of any name find each other, and an orthographic camera comes back") {
  Scene scene = scene_of(triangle(), Principled{});
  scene.textures = {{"", ImageTexture{picture(), WrapMode::repeat, TextureFilter::nearest, {}}}};
  scene.materials[0].textures = {{MaterialInput::reflectance, 0}};
  scene.camera.projection = Projection::orthographic;
  scene.camera.tan_half_width = 4, scene.camera.tan_half_height = 3;
  const RoundTrip trip = round_trip(scene, "a 100%25 #1?\xc3\xa4.gltf");
  CHECK(trip.warnings.empty());
  CHECK(texture_of(trip, MaterialInput::reflectance) != no_texture);
  CHECK(trip.scene.camera.projection == Projection::orthographic);
  CHECK(difference(scene.camera, trip.scene.camera) <= rounding);
}

TEST_CASE("written gltf: the bounds of positions are said, and shapes without a surface are left out") {
  Scene scene = scene_of(triangle(), Lambert{});
  scene.materials.push_back({"nothing", Interface{}});
  scene.bindings = {{0}, {1}};
  scene.geometry = std::make_shared<const Geometry>(std::vector<Shape>{triangle(), triangle()});
  const RoundTrip trip = round_trip(scene, "a.gltf");
  CHECK(trip.warnings == std::vector<std::string>{"a shape without a surface is left out"});
  const auto json = nlohmann::json::parse(trip.text);
  CHECK(json["meshes"].size() == 1);
  const auto& positions =
      json["accessors"][json["meshes"][0]["primitives"][0]["attributes"]["POSITION"].get<int>()];
  CHECK(positions["min"] == nlohmann::json({0, 0, 0}));
  CHECK(positions["max"] == nlohmann::json({1, 1, 0}));
  CHECK(json["buffers"][0]["uri"] == "a.bin");
}

TEST_CASE("written gltf: what bodies and the atmosphere scatter is named, and what is not even") {
  Principled clear;
  clear.transmission_weight = 1;
  Scene scene = scene_of(triangle(), clear);
  scene.densities = {
      std::make_shared<const DensityGrid>(DensityGrid::Size{1, 1, 1}, std::vector<float>{1}, Transform{})};
  scene.materials[0].interior = {
      .absorption = {1, 1, 1}, .scattering = {0, 0, 1}, .density = 0, .glow = {.radiance = {1, 0, 0}}};
  scene.materials.push_back({"air", Interface{}, {}, {.scattering = {1, 1, 1}}});
  scene.atmosphere = 1;
  CHECK(round_trip(scene, "a.gltf").warnings ==
        std::vector<std::string>{"what a body scatters within is left out",
                                 "the light that a body's medium emits is left out",
                                 "a body whose medium is not even is filled evenly",
                                 "what fills the space around the camera is left out"});
}

TEST_CASE("written gltf: where the texture of a sphere lies is named") {
  const std::string around = "2 spheres are meshes of 256 edges around";
  Scene scene = scene_of(SphereSet{"spheres", {{{0, 0, 0}, 1}, {{3, 0, 0}, 1}}}, Lambert{});
  scene.textures = {{"", ImageTexture{picture(), WrapMode::repeat, TextureFilter::nearest, {}}}};
  CHECK(round_trip(scene, "a.gltf").warnings == std::vector<std::string>{around});
  const std::vector<std::string> named = {around, "the textures of 2 spheres lie around their z axes"};
  scene.bindings[0].alpha = 0;
  CHECK(round_trip(scene, "a.gltf").warnings == named);
  scene.bindings[0].alpha = no_texture;
  scene.materials[0].textures = {{MaterialInput::reflectance, 0}};
  CHECK(round_trip(scene, "a.gltf").warnings == named);
}

}  // namespace twinray::test
