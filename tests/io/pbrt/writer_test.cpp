// SPDX-License-Identifier: Apache-2.0
// Scenes written in pbrt's format are read again: what comes back is what was there.
#include "io/pbrt/writer.h"

#include <algorithm>
#include <cmath>

#include "core/alpha_test.h"
#include "core/direction_map.h"
#include "core/instance.h"
#include "core/textured_material.h"
#include "io/scene_file.h"
#include "io/scene_writer.h"
#include "tests/io/pbrt/written_parts.h"
#include "tests/support/catch.h"
#include "tests/support/round_trip.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {
namespace {

LoadedScene load(const std::string& name) {
  return load_scene(TWINRAY_SOURCE_DIR "/scenes/" + name, {.instances = InstanceUse::keep});
}

}  // namespace

TEST_CASE("written pbrt: this project's scenes of plain materials come back as they were") {
  for (const char* name : {"box.dae", "cornell-bunny.dae", "spheres.dae", "furnace.dae", "materials.pbrt",
                           "pawns.pbrt", "still-life.pbrt"}) {
    INFO(name);
    const Scene scene = load(name).scene;
    const RoundTrip trip = round_trip(scene, "a.pbrt");
    CHECK(trip.warnings.empty());
    const GeometryDifference apart = difference(scene, trip.scene);
    CHECK(apart.fault == "");
    CHECK(apart.positions == 0);
    CHECK(apart.uvs == 0);
    CHECK_FALSE(apart.has_lost_uvs);
    CHECK(apart.normals <= 1.2e-7f);  // The reader makes them unit vectors again.
    CHECK(first_difference(surfaces(scene), surfaces(trip.scene), 0) == "");
    CHECK(first_difference(free_lights(scene), free_lights(trip.scene), 1e-6) == "");
    CHECK(difference(scene.camera, trip.scene.camera) <= 4 * rounding);
  }
}

TEST_CASE("written pbrt: each camera that pbrt has sees the same") {
  Camera base;
  base.position = {1.25f, -2.5f, 3};
  base.forward = normalize(Vec3{1, 2, -3});
  base.right = normalize(cross(base.forward, {0, 1, 0}));
  base.up = cross(base.right, base.forward);
  Scene scene = scene_of(plain_triangle(), Lambert{});
  const auto comes_back = [&](const Camera& camera) {
    scene.camera = camera;
    const RoundTrip trip = round_trip(scene, "a.pbrt");
    CHECK(trip.warnings.empty());
    CHECK(trip.scene.camera.projection == camera.projection);
    CHECK(difference(camera, trip.scene.camera) <= 4 * rounding);
  };
  comes_back(base);
  Camera mirrored = base;
  mirrored.right = -base.right;
  comes_back(mirrored);
  Camera shifted = base;
  shifted.frame_center = {0.125f, -0.25f};
  shifted.lens_radius = 0.25f, shifted.focal_distance = 7;
  comes_back(shifted);
  Camera stretched = base;
  stretched.is_stretched = true;
  stretched.tan_half_width = 0.3f;
  comes_back(stretched);
  Camera parallel = shifted;
  parallel.projection = Projection::orthographic;
  parallel.tan_half_width = 4, parallel.tan_half_height = 3;
  comes_back(parallel);
  comes_back(with_panorama(base, Projection::latitude_longitude, 0));
  comes_back(with_panorama(base, Projection::equal_area, 0));
}

TEST_CASE("written pbrt: what pbrt's cameras have not is named") {
  Scene scene = scene_of(plain_triangle(), Lambert{});
  scene.camera.clip_far = 10;
  scene.camera.lens_radius = 0.5f, scene.camera.aperture_blades = 5;
  CHECK(round_trip(scene, "a.pbrt").warnings ==
        std::vector<std::string>{"the camera's clip distances are left out",
                                 "the blades of the camera's lens are left out: it is round"});
  scene.camera = with_panorama({}, Projection::fisheye, 0.5f);
  const RoundTrip trip = round_trip(scene, "a.pbrt");
  CHECK(trip.warnings == std::vector<std::string>{
                             "the fisheye camera is a perspective one, whose frame is as wide as far as a "
                             "plane goes"});
  CHECK(trip.scene.camera.tan_half_height == Approx(std::tan(0.5)));
}

TEST_CASE("written pbrt: a part of a panorama is named, and very narrow and wide views come back") {
  Scene scene = scene_of(plain_triangle(), Lambert{});
  for (const Projection projection : {Projection::latitude_longitude, Projection::equal_area}) {
    scene.camera = with_panorama({}, projection, 0);
    scene.camera.tan_half_height *= 0.5f;
    CHECK(round_trip(scene, "a.pbrt").warnings ==
          std::vector<std::string>{
              "the camera's frame is all around, for pbrt's spherical cameras see no part of it"});
  }
  for (const float tangent : {1e-7f, 3e4f}) {
    scene.camera = Camera{};
    scene.camera.tan_half_width = scene.camera.tan_half_height = tangent;
    const RoundTrip trip = round_trip(scene, "a.pbrt");
    CHECK(trip.warnings.empty());
    CHECK(trip.scene.camera.tan_half_height == Approx(tangent));
  }
}

TEST_CASE("written pbrt: what a file said of its picture stays, and nothing else is said of the filter") {
  const Scene scene = scene_of(plain_triangle(), Lambert{});
  RenderDefaults picture{
      .resolution = {{320, 200}}, .crop = {{10, 20, 30, 40}}, .samples = 48, .max_depth = 7};
  picture.filter = PixelFilter{FilterKind::mitchell, {1.5f, 2.5f}, 0.5f, 0.25f, 0.5f};
  picture.daylight_kelvin = 4500;
  const TemporaryFolder folder;
  const WrittenScene written = written_pbrt({scene, picture}, folder.file("a.pbrt"));
  CHECK(written.warnings.empty());
  write_files(written);
  const RenderDefaults read = load_scene(folder.file("a.pbrt"), {.strict = true}).defaults;
  CHECK(read.resolution->width == 320);
  CHECK(read.resolution->height == 200);
  CHECK(read.crop == picture.crop);
  CHECK(read.samples == 48);
  CHECK(read.max_depth == 7);
  CHECK(read.filter == picture.filter);
  CHECK(read.daylight_kelvin == 4500.0);
  const std::string text = round_trip(scene, "a.pbrt").text;
  CHECK(text.find("PixelFilter") == text.npos);
  CHECK(text.find("whitebalance") == text.npos);
  CHECK(text.find("Sampler") == text.npos);
}

TEST_CASE("written pbrt: each material that pbrt has comes back, with every bit but the last of an index") {
  const Roughness even{0.3f, 0.3f}, uneven{0.123f, 0.456f};
  for (const SurfaceModel& model : std::initializer_list<SurfaceModel>{
           Lambert{{0.1f, 0.7f, 0.3f}}, Dielectric{1.33f}, Dielectric{1.7f, even}, Dielectric{1.7f, uneven},
           Dielectric{.ior = 1.4f, .is_thin = true},
           Conductor{{0.3f, 0.4f, 1.5f}, {3.1f, 2.2f, 1.9f}, uneven},
           DiffuseTransmission{{0.1f, 0.2f, 0.3f}, {0.5f, 0.4f, 0.3f}},
           CoatedDiffuse{{0.1f, 0.2f, 0.3f}, even, 1.6f},
           CoatedConductor{{0.3f, 0.4f, 1.5f}, {3.1f, 2.2f, 1.9f}, even, {1, 1, 1}, uneven, 1.45f}}) {
    const Scene scene = scene_of(plain_triangle(), model);
    const RoundTrip trip = round_trip(scene, "a.pbrt");
    CHECK(trip.warnings.empty());
    auto wanted = surfaces(scene), read = surfaces(trip.scene);
    for (const char* index : {"ior", "coat_ior"})
      if (wanted[0]["material"].contains(index)) {
        CHECK(wanted[0]["material"][index].get<float>() == Approx(read[0]["material"][index].get<float>()));
        read[0]["material"][index] = wanted[0]["material"][index];
      }
    CHECK(first_difference(wanted, read, 0) == "");
    CHECK(only_material(trip).name == "stuff");
  }
}

TEST_CASE("written pbrt: mixtures, bodies that absorb, and names that are not unique") {
  Scene scene = scene_of(plain_triangle(), Lambert{{0.1f, 0.2f, 0.3f}});
  scene.materials.push_back({"stuff", Conductor{}});
  scene.materials.push_back({"\"mixed\\", Mix{0, 1, 0.25f}});
  scene.bindings[0].material = 2;
  RoundTrip trip = round_trip(scene, "a.pbrt");
  CHECK(trip.warnings.empty());
  const Material& made = only_material(trip);
  CHECK(made.name == "\"mixed\\");
  const Mix mix = std::get<Mix>(made.model);
  CHECK(mix.amount == 0.25f);
  CHECK(std::get<Lambert>(trip.scene.materials[mix.first].model).reflectance == Rgb{0.1f, 0.2f, 0.3f});
  CHECK(trip.scene.materials[mix.second].name == "stuff 2");
  scene = scene_of(plain_triangle(), Dielectric{});
  scene.materials[0].interior = {{0.5f, 0.25f, 0}, 3};
  trip = round_trip(scene, "a.pbrt");
  CHECK(only_material(trip).interior.absorption == Rgb{0.5f, 0.25f, 0});
  CHECK(trip.warnings == std::vector<std::string>{"the priority of a body that overlaps others is left out"});
}

TEST_CASE("written pbrt: a material that pbrt has not is the nearest one, and is named") {
  const auto comes_back = [](const SurfaceModel& model, const std::string& warning) {
    const RoundTrip trip = round_trip(scene_of(plain_triangle(), model), "a.pbrt");
    CHECK(trip.warnings == std::vector<std::string>{warning});
    return only_material(trip).model;
  };
  const auto metal = std::get<Conductor>(
      comes_back(Microfacet{0.25f, {1, 2, 3}, {4, 5, 6}},
                 "a material of the type microfacet is written as a conductor of GGX facets"));
  CHECK(metal.eta == Rgb{1, 2, 3});
  CHECK(metal.roughness == Roughness{0.25f, 0.25f});
  CHECK(std::get<Dielectric>(comes_back(Glass{{1, 1, 1}, {0.5f, 1, 1}, 0, 1.25f},
                                        "the color of a material of the type glass is left out"))
            .ior == 1.25f);
  CHECK(std::get<Lambert>(comes_back(RoughDiffuse{{0.2f, 0.3f, 0.4f}},
                                     "a material of the type rough_diffuse is written as a diffuse surface"))
            .reflectance == Rgb{0.2f, 0.3f, 0.4f});
  comes_back(Mirror{}, "a material of the type mirror is written as a smooth conductor");
  comes_back(Refraction{},
             "a material of the type refraction is written as a dielectric, which also reflects");
  Principled model;
  model.base_color = {0.5f, 0.25f, 0.125f};
  model.specular_roughness = 0.5f;
  const auto coated = std::get<CoatedDiffuse>(
      comes_back(model, "a material of the type openpbr is written as a coated diffuse surface"));
  CHECK(coated.reflectance == model.base_color);
  CHECK(coated.roughness == Roughness{0.25f, 0.25f});
  model.base_metalness = 1;
  comes_back(model, "a material of the type openpbr is written as a conductor");
  model.base_metalness = 0, model.transmission_weight = 1, model.specular_ior = 1.25f;
  CHECK(std::get<Dielectric>(comes_back(model, "a material of the type openpbr is written as a dielectric"))
            .ior == 1.25f);
  Scene several = scene_of(plain_triangle(), Mirror{});
  several.materials.push_back({"b", Mirror{}});
  several.materials.push_back({"no shape has this", Mirror{}});
  several.bindings = {{0}, {1}};
  several.geometry = std::make_shared<const Geometry>(std::vector<Shape>{plain_triangle(), plain_triangle()});
  CHECK(round_trip(several, "a.pbrt").warnings ==
        std::vector<std::string>{"2 materials of the type mirror are written as smooth conductors"});
}

TEST_CASE("written pbrt: the direction of facets is named where it is not that of the texture coordinates") {
  Scene scene = scene_of(mapped_triangle(), Conductor{.roughness = {0.125f, 0.5f}});
  CHECK(round_trip(scene, "a.pbrt").warnings.empty());
  scene.materials[0].tangent_degrees = 30;
  CHECK(round_trip(scene, "a.pbrt").warnings ==
        std::vector<std::string>{
            "the direction of the facets of a material of the type conductor is left out"});
  scene.materials[0].model = Conductor{.roughness = {0.5f, 0.5f}};
  CHECK(round_trip(scene, "a.pbrt").warnings.empty());
}

TEST_CASE("written pbrt: each light that pbrt has comes back") {
  Scene scene = scene_of(plain_triangle(), Lambert{});
  const auto square = std::make_shared<Image>(2, 2);
  square->pixels = {{0.1f, 0.1f, 0.1f}, {2, 2, 2}, {3, 3, 3}, {4, 4, 4}};
  const auto wide = std::make_shared<Image>(2, 1);
  wide->pixels = {{0.1f, 0.2f, 0.3f}, {2, 3, 4}};
  const auto one = std::make_shared<Image>(1, 1);
  one->pixels = {{0.5f, 0.25f, 1}};
  const Transform turn = Transform::rotation({1, 2, 3}, 40);
  const Vec3 along = normalize(Vec3{1, -2, 0.5f}), right = normalize(cross(along, {0, 1, 0}));
  scene.lights = {
      {"", PointLight{{1, 2, 3}, {4, 5, 6.1f}}},
      {"", SpotLight{{100.1f, 2, 3}, along, {4, 5, 6}, {}, 35.5f, 0, 4.25f}},
      {"", DirectionalLight{along, {0.1f, 0.2f, 3e5f}}},
      {"", EnvironmentLight{one, MapLayout::latitude_longitude, {}, {3, 2, 1}}},
      {"", EnvironmentLight{square, MapLayout::equal_area, turn, {3, 3, 3}}},
      {"", GoniometricLight{{1, 2, 3}, {4, 5, 6}, square, MapLayout::equal_area, turn}},
      {"", ProjectionLight{{1, 2, 3}, right, cross(right, along), along, 0.75f, 0.375f, {2, 2, 2}, wide}}};
  const RoundTrip trip = round_trip(scene, "a.pbrt");
  CHECK(trip.warnings.empty());
  auto wanted = free_lights(scene);
  wanted[3] = {{"type", "environment"},
               {"layout", "latitude-longitude"},
               {"rotation", wanted[3]["rotation"]},
               {"scale", {1, 1, 1}}};  // The color stands in the picture's one pixel.
  CHECK(first_difference(wanted, free_lights(trip.scene), 1e-6) == "");
  const auto& sky = std::get<EnvironmentLight>(trip.scene.lights[3].source);
  CHECK(sky.map->pixels == std::vector<Rgb>{{1.5f, 0.5f, 1}});
  CHECK(std::get<EnvironmentLight>(trip.scene.lights[4].source).map->pixels == square->pixels);
  CHECK(std::get<GoniometricLight>(trip.scene.lights[5].source).map->pixels == square->pixels);
  CHECK(std::get<ProjectionLight>(trip.scene.lights[6].source).picture->pixels == wide->pixels);
  CHECK(std::get<PointLight>(trip.scene.lights[0].source).intensity == Rgb{4, 5, 6.1f});
}

TEST_CASE("written pbrt: lights that pbrt has not are others of the same strength, and are named") {
  Scene scene = scene_of(plain_triangle(), Lambert{});
  const auto map = std::make_shared<Image>(64, 32);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 64; ++x) map->at(x, y) = {float(y), 1 + float(x % 7), 0.5f};
  scene.lights = {{"", AmbientLight{{0, 1, 0}, {1, 2, 3}}},
                  {"", EnvironmentLight{map, MapLayout::latitude_longitude, {}, {1, 1, 2}}},
                  {"", SunLight{{0, -1, 0}, {4, 5, 6}}},
                  {"", PointLight{{}, {1, 1, 1}, {1, 0, 0}}},
                  {"", SpotLight{.intensity = {1, 1, 1}, .falloff_exponent = 2}}};
  const RoundTrip trip = round_trip(scene, "a.pbrt");
  CHECK(trip.warnings == std::vector<std::string>{
                             "an ambient light is an environment, which is seen",
                             "an environment light is drawn anew as a square of equal areas",
                             "a sun light is a direction, without a disc",
                             "a point light falls off with the square of the distance, not as the scene says",
                             "a spot light is as bright beside its axis as along it"});
  const auto& ambient = std::get<EnvironmentLight>(trip.scene.lights[0].source);
  CHECK(mean_of(*ambient.map) == Rgb{0.5f, 1, 1.5f});  // A half of all directions.
  CHECK(dot(ambient.rotation.vector({0, 0, 1}), {0, 1, 0}) == Approx(1));
  const auto& sky = std::get<EnvironmentLight>(trip.scene.lights[1].source);
  CHECK(sky.layout == MapLayout::equal_area);
  // Rows weighed by the sine of their angle.
  double sum = 0, weights = 0;
  for (int y = 0; y < 32; ++y) {
    const double weight = std::sin(3.14159265 * (y + 0.5) / 32);
    sum += weight * y, weights += weight;
  }
  CHECK(double(mean_of(*sky.map).r) == Approx(sum / weights).epsilon(2e-3));
  CHECK(mean_of(*sky.map).b == Approx(1));
  CHECK(std::get<DirectionalLight>(trip.scene.lights[2].source).irradiance == Rgb{4, 5, 6});
}

TEST_CASE("written pbrt: a projection keeps its frame's sides, lost goniometric colors are named") {
  Scene scene = scene_of(plain_triangle(), Lambert{});
  const auto picture = std::make_shared<Image>(2, 2);
  picture->pixels = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  ProjectionLight slide{.intensity = {1, 1, 1}, .picture = picture};
  slide.tan_half_width = 0.2f, slide.tan_half_height = 0.37f;
  scene.lights = {{"", slide}, {"", GoniometricLight{{}, {1, 1, 1}, picture, MapLayout::equal_area}}};
  const RoundTrip trip = round_trip(scene, "a.pbrt");
  CHECK(trip.warnings ==
        std::vector<std::string>{
            "a projection light has a picture that is drawn anew, with the sides of its frame",
            "a goniometric light shines in one color, by the mean of its picture's channels"});
  const auto& shown = std::get<ProjectionLight>(trip.scene.lights[0].source);
  CHECK(shown.tan_half_width == Approx(0.2).epsilon(0.01));
  CHECK(shown.tan_half_height == Approx(0.37).epsilon(0.01));
  const auto light = [](const ProjectionLight& of, Vec2 frame) {
    return clamped_value(*of.picture, {double(frame.x), double(frame.y)});
  };
  for (const Vec2 frame : {Vec2{0.1f, 0.2f}, {0.5f, 0.5f}, {0.4f, 0.7f}, {0.9f, 0.6f}}) {
    const Rgb change = light(shown, frame) - light(slide, frame);
    CHECK(std::fabs(change.r) < 0.01f);
    CHECK(std::fabs(change.g) < 0.01f);
    CHECK(std::fabs(change.b) < 0.01f);
  }
}

TEST_CASE("written pbrt: spheres have pbrt's directions of facets, and those without a radius are left out") {
  Scene scene;
  scene.geometry = std::make_shared<const Geometry>(
      std::vector<Shape>{SphereSet{"", {{{0, 0, 0}, 1}, {{3, 0, 0}, -0.0f}}}});
  scene.bindings = {{0}};
  scene.materials = {{"", Conductor{.roughness = {0.5f, 0.1f}}}};
  const RoundTrip trip = round_trip(scene, "a.pbrt");
  CHECK(trip.warnings == std::vector<std::string>{"the facets of 2 spheres lie as pbrt's spheres have them"});
  CHECK(trip.scene.geometry->shapes().size() == 1);
  CHECK(round_trip(scene, "a.gltf").warnings ==
        std::vector<std::string>{"a material of the type conductor is written as a metal of its color",
                                 "2 spheres are meshes of 256 edges around",
                                 "the facets of 2 spheres are longer around their z axes"});
}

TEST_CASE("written pbrt: a surface with an inside whose back emits is named") {
  Scene scene = scene_of(plain_triangle(), Dielectric{.ior = 1.5f});
  scene.bindings[0].light = 0;
  for (const EmissionSide side : {EmissionSide::front, EmissionSide::back}) {
    scene.lights = {{"", MeshLight{0, {1, 1, 1}, side}}};
    std::vector<std::string> expected;
    if (side == EmissionSide::back)
      expected = {"a surface whose back emits is turned around, so that its outside is within"};
    CHECK(round_trip(scene, "a.pbrt").warnings == expected);
    CHECK(round_trip(scene, "a.gltf").warnings == expected);
  }
}

TEST_CASE("written pbrt: emitters come back with their side, radiance and picture") {
  const auto glow = std::make_shared<Image>(2, 1);
  glow->pixels = {{0.1f, 0.2f, 0.3f}, {2, 3, 4}};
  Mesh mesh = mapped_triangle();
  for (const EmissionSide side : {EmissionSide::front, EmissionSide::back, EmissionSide::both}) {
    Scene scene = scene_of(mesh, Lambert{});
    scene.bindings[0].light = 0;
    scene.lights = {{"", MeshLight{0, {1.1f, 2.2f, 3e4f}, side}}};
    RoundTrip trip = round_trip(scene, "a.pbrt");
    CHECK(trip.warnings.empty());
    const auto& light = std::get<MeshLight>(trip.scene.lights[0].source);
    CHECK(light.radiance == Rgb{1.1f, 2.2f, 3e4f});
    CHECK(light.side == (side == EmissionSide::both ? side : EmissionSide::front));
    // What emits to its back is turned around.
    const bool is_turned = trip.scene.geometry->facet(0, 0).normal.z < 0;
    CHECK(is_turned == (side == EmissionSide::back));
    std::get<MeshLight>(scene.lights[0].source).picture = glow;
    trip = round_trip(scene, "a.pbrt");
    const auto& shown = std::get<MeshLight>(trip.scene.lights[0].source);
    REQUIRE(shown.picture);
    CHECK(shown.radiance * shown.picture->pixels[1] == Rgb{2.2f, 6.6000004f, 1.2e5f});
  }
}

TEST_CASE("written pbrt: normals on the other side of a triangle are turned, so that its front stays") {
  Mesh mesh = plain_triangle();
  mesh.positions.push_back({1, 1, 0});
  mesh.triangles.push_back({1, 3, 2});
  mesh.normals = {{0, 0, 1}, {0, 0.6f, -0.8f}};
  mesh.normal_indices = {{0, 0, 0}, {1, 1, 1}};
  const Scene scene = scene_of(mesh, Lambert{});
  const RoundTrip trip = round_trip(scene, "a.pbrt");
  const GeometryDifference apart = difference(scene, trip.scene);
  CHECK(apart.fault == "");
  CHECK(apart.positions == 0);
  CHECK(apart.normals <= 1.2e-7f);
  const Mesh& read = *trip.scene.geometry->mesh(0);
  CHECK(read.normals[read.normal_indices[1][0]].z > 0);
}

TEST_CASE("written pbrt: what is shown by instances is stored once, wherever it stands") {
  Scene scene = scene_of(plain_triangle(), Lambert{});
  Transform place = Transform::translation(1, 2, 3) * Transform::rotation({1, 1, 0}, 30);
  place.m[0][0] += 0.1;
  scene.bindings.resize(3);
  scene.geometry = std::make_shared<const Geometry>(
      std::vector<Shape>{plain_triangle(), SphereSet{"ball", {{{1, 2, 3}, 0.5f}}}, plain_triangle()}, nullptr,
      Instancing{{{1, 2}}, {{0, place}, {0, {}}}});
  const RoundTrip trip = round_trip(scene, "a.pbrt");
  CHECK(trip.warnings.empty());
  const GeometryDifference apart = difference(scene, trip.scene);
  CHECK(apart.fault == "");
  CHECK(apart.positions == 0);
  CHECK(trip.scene.geometry->prototypes() == scene.geometry->prototypes());
  REQUIRE(trip.scene.geometry->instances().size() == 2);
  const Transform& read = trip.scene.geometry->instances()[0].to_world;
  CHECK(std::equal(&read.m[0][0], &read.m[0][0] + 12, &place.m[0][0]));
}

}  // namespace twinray::test
