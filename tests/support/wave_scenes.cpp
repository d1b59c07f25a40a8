// SPDX-License-Identifier: Apache-2.0
#include "tests/support/wave_scenes.h"

#include <memory>
#include <utility>
#include <vector>

#include "core/textured_material.h"
#include "tests/support/measured_facets.h"
#include "tests/support/principled_models.h"
#include "tests/support/random.h"
#include "tests/support/scenes.h"
#include "tests/support/shapes.h"

namespace twinray::test {
namespace {

/// A picture of random colours, some of them black.
std::shared_ptr<const Image> random_picture(int width, int height) {
  auto map = std::make_shared<Image>(width, height);
  Random random(5);
  for (Rgb& pixel : map->pixels) pixel = {random.below(3) == 0 ? 0 : random.unit(), random.unit(), 0.25f};
  return map;
}

std::shared_ptr<const Image> random_sky() { return random_picture(8, 4); }
std::shared_ptr<const Image> random_square() { return random_picture(5, 5); }

/// Corner normals that contradict the geometry here and there.
void add_normals(Mesh& mesh) {
  Random random(11);
  for (const Triangle& triangle : mesh.triangles) {
    const auto first = std::uint32_t(mesh.normals.size());
    for (int corner = 0; corner < 3; ++corner) mesh.normals.push_back(normalize(random.in_ball()));
    mesh.normal_indices.push_back({first, first + 1, first + 2});
    static_cast<void>(triangle);
  }
}

/// A lamp of triangles of very different areas, the last of them without any.
Mesh lamp_of(int triangles) {
  Mesh mesh{.name = "lamp"};
  float size = 0.001f;
  for (int i = 0; i < triangles; ++i, size *= 5)
    add_triangle(mesh, {size, 1.3f, size}, {2 * size, 1.4f, size}, {size, 1.5f, -size});
  mesh.triangles.back()[2] = mesh.triangles.back()[1];
  return mesh;
}

/// Random triangles of each of the models.
void add_models(Scene& scene, const std::vector<SurfaceModel>& models) {
  std::vector<Shape> shapes = scene.geometry->shapes();
  for (const SurfaceModel& model : models) {
    scene.bindings.push_back({std::uint32_t(scene.materials.size())});
    scene.materials.push_back({"", model});
    shapes.push_back(soup(12, 0.7f, scene.materials.size()));
  }
  scene.geometry = std::make_shared<const Geometry>(std::move(shapes));
}

/// A ball of a material.
void add_ball(Scene& scene, std::uint32_t material, const Sphere& ball) {
  std::vector<Shape> shapes = scene.geometry->shapes();
  scene.bindings.push_back({material});
  shapes.push_back(SphereSet{"", {ball}});
  scene.geometry = std::make_shared<const Geometry>(std::move(shapes));
}

/// Every light that rays find by leaving the scene.
void add_distant_lights(Scene& scene) {
  add_light(scene, AmbientLight{{0, 1, 0}, {0.1f, 0.2f, 0.1f}});
  add_light(scene, EnvironmentLight{random_sky()});
  EnvironmentLight square{random_square(), MapLayout::equal_area};
  square.rotation = Transform::rotation({1, 2, 3}, 40);
  square.scale = {0.5f, 0.25f, 1};
  add_light(scene, std::move(square));
  add_light(scene, SunLight{normalize({-1, -2, 1}), {0.5f, 0.3f, 0.2f}, 5});
}

/// Lamps of every shape: of one patch, of two, of too many, of none.
Mesh lamp_of_kind(int kind) {
  Mesh lamp = kind == 3 ? inward_box(0.1f) : floor_square(0.1f, 0);
  if (kind == 1) lamp.triangles.resize(1);
  if (kind == 2) lamp.positions[0].y += 0.05f;  // Its two triangles are no parallelogram.
  if (kind == 4) lamp = soup(20, 0.1f, 5);
  return lamp;
}

/// Texture coordinates for every other mesh; the others have the weights of their hits.
void add_uvs(Scene& scene) {
  std::vector<Shape> shapes = scene.geometry->shapes();
  Random random(50);
  for (std::size_t i = 0; i < shapes.size(); i += 2)
    if (auto* const mesh = std::get_if<Mesh>(&shapes[i])) {
      mesh->uv_indices = mesh->triangles;
      mesh->uvs.resize(mesh->positions.size());
      for (Vec2& uv : mesh->uvs) uv = {random.unit(), random.unit()};
      if (i % 8 == 0) continue;
      mesh->second_uv_indices = mesh->triangles;
      mesh->second_uvs.resize(mesh->positions.size());
      for (Vec2& uv : mesh->second_uvs) uv = {random.unit(), 3 * random.unit()};
    }
  scene.geometry = std::make_shared<const Geometry>(std::move(shapes));
}

}  // namespace

Scene scene_under_skies() {
  Scene scene = scene_of(soup(40, 0.7f, 3), {0.8f, 0.7f, 0.6f}, {0, 0.3f, 1.6f}, {0, 0, 0});
  add_models(scene, {Conductor{}});
  add_distant_lights(scene);
  return scene;
}

Scene scene_of_everything() {
  Mesh mesh = soup(60, 0.7f, 3);
  add_normals(mesh);
  Scene scene = scene_of(std::move(mesh), {0.8f, 0.7f, 0}, {0, 0.3f, 1.6f}, {0, 0, 0});
  add_lamp(scene, floor_square(0.5f, 1.2f), {3, 2, 1}, EmissionSide::both);
  add_lamp(scene, floor_square(0.25f, -0.9f), {1, 2, 3}, EmissionSide::front);
  add_lamp(scene, lamp_of(4), {1, 1, 2}, EmissionSide::both);
  add_lamp(scene, lamp_of(5), {2, 1, 1}, EmissionSide::both);
  Mesh bulb = icosphere(1);
  for (Vec3& p : bulb.positions) p = p * 0.15f + Vec3{-0.6f, 0.4f, 0.5f};
  add_lamp(scene, std::move(bulb), {3, 2, 3}, EmissionSide::front);
  add_lamp(scene, inward_box(1.7f), {0.1f, 0.1f, 0.2f}, EmissionSide::back);
  add_lamp(scene, SphereSet{"ball", {{{0.3f, 0.8f, 0.4f}, 0.2f}}}, {2, 2, 2}, EmissionSide::front);
  add_light(scene, PointLight{{0.3f, 0.2f, 0.1f}, {1, 2, 3}, {}});
  add_light(scene, SpotLight{{0, 1, 0}, {0, -1, 0}, {4, 4, 4}, {}, 70, 2});
  add_light(scene, DirectionalLight{normalize({1, -2, -1}), {0.5f, 0.5f, 0.4f}});
  add_distant_lights(scene);
  add_light(scene, GoniometricLight{{-0.4f, 0.5f, 0.6f}, {1, 2, 1}, random_square()});
  ProjectionLight slide{.position = {0.5f, 0.5f, 1.2f}, .intensity = {3, 2, 1}, .picture = random_sky()};
  add_light(scene, std::move(slide));
  return scene;
}

Scene scene_of_every_model() {
  Scene scene = scene_of_everything();
  const SurfaceModel models[] = {Mirror{{0.9f, 0.8f, 0.7f}},
                                 Refraction{.ior = 1.3f},
                                 Glass{{0.9f, 1, 0.8f}, {1, 0.5f, 1}, 0, 1.5f},
                                 Microfacet{.alpha = 0.4f},
                                 Dielectric{.ior = 1.4f},
                                 Dielectric{.ior = 1.5f, .roughness = {0.3f, 0.2f}},
                                 Dielectric{.is_thin = true},
                                 Conductor{},
                                 Conductor{.roughness = {0.1f, 0.4f}},
                                 DiffuseTransmission{},
                                 RoughDiffuse{},
                                 CoatedDiffuse{},
                                 CoatedDiffuse{.roughness = {0.2f, 0.2f}},
                                 CoatedConductor{},
                                 CoatedConductor{.roughness = {0.3f, 0.3f}, .coat_roughness = {0.2f, 0.2f}},
                                 measured_material({0.9f, 0.6f, 0.3f}),
                                 measured_material({0.4f, 0.6f, 0.9f}, 5),
                                 Principled{.base_color = {0.8f, 0.5f, 0.2f}},
                                 Principled{.base_diffuse_roughness = 0.7f,
                                            .base_metalness = 0.4f,
                                            .specular_weight = 0.8f,
                                            .specular_color = {0.9f, 0.7f, 1},
                                            .specular_roughness = 0.5f},
                                 Principled{.base_metalness = 1, .specular_roughness = 0.7f},
                                 brushed(),
                                 varnished(),
                                 oiled(),
                                 clear(),
                                 Principled{.fuzz_weight = 0.5f},
                                 Principled{.specular_roughness = 0.4f, .transmission_weight = 0.5f},
                                 Mix{0, 4, 0.3f}};
  std::vector<Shape> shapes = scene.geometry->shapes();
  std::uint64_t seed = 20;
  for (const SurfaceModel& model : models) {
    scene.materials.push_back({"", model});
    const auto material = std::uint32_t(scene.materials.size() - 1);
    Mesh mesh = soup(12, 0.7f, seed++);
    if (seed % 2 == 0) add_normals(mesh);
    shapes.push_back(std::move(mesh));
    shapes.push_back(SphereSet{"", {{Random(seed).in_ball(), 0.2f}}});
    scene.bindings.push_back({material});
    scene.bindings.push_back({material});
  }
  scene.geometry = std::make_shared<const Geometry>(std::move(shapes));
  return scene;
}

Scene scene_of_interiors() {
  Scene scene = scene_of_every_model();
  std::vector<Shape> shapes = scene.geometry->shapes();
  Random random(30);
  for (int i = 0; i < 12; ++i) {
    const float ior = 1.1f + 0.1f * float(i % 5);
    Material material{"", i % 3 == 0 ? SurfaceModel(Interface{}) : Dielectric{ior}};
    if (i % 4 == 1) material.model = Dielectric{ior, {0.3f, 0.3f}};
    material.interior = {{random.unit(), i % 2 == 0 ? 0 : random.unit(), 0.5f}, i % 4};
    scene.materials.push_back(material);
    scene.bindings.push_back({std::uint32_t(scene.materials.size() - 1)});
    shapes.push_back(SphereSet{"", {{random.in_ball() * 0.3f, i == 0 ? 1.3f : 0.5f}}});
  }
  scene.geometry = std::make_shared<const Geometry>(std::move(shapes));
  check_scene(scene);
  return scene;
}

Scene scene_without_passages() {
  Scene scene = scene_of_interiors();
  for (Material& material : scene.materials)
    if (std::holds_alternative<Interface>(material.model)) material.model = Dielectric{1.2f};
  return scene;
}

Scene scene_in_media() {
  Scene scene = scene_of_interiors();
  scene.densities = {std::make_shared<const DensityGrid>(
      DensityGrid::Size{2, 3, 2}, std::vector<float>{0, 9, 4, 1, 0, 3, 8, 0, 2, 5, 9, 1},
      Transform::scaling(0.4, 0.4, 0.4) * Transform::translation(1.2, 1.2, 1.2))};
  scene.densities.push_back(std::make_shared<const DensityGrid>(
      DensityGrid::Size{1, 2, 2}, std::vector<float>{1500, 3000, 8000, 500}, scene.densities[0]->to_unit()));
  std::uint32_t next = 0;
  for (Material& material : scene.materials) {
    Interior& interior = material.interior;
    if (is_black(interior.absorption)) continue;
    interior.scattering = Rgb{2, 0.5f, 1} * (0.25f * float(next));
    interior.anisotropy = 0.2f * float(next % 7) - 0.6f;
    if (next++ == 3) interior.density = 0;
    if (next % 3 == 0) interior.glow.radiance = {0.5f, 1, 2};
    if (next == 3) interior.glow.factor = 0;
    if (next == 6) interior.glow.temperature = 1;
  }
  add_models(scene, {Hair{}, Hair{.reflectance = white, .longitudinal_roughness = 0.1f}});
  add_ball(scene, std::uint32_t(scene.materials.size() - 1), {{0.4f, 0.3f, 0.2f}, 0.3f});
  scene.materials.push_back({.name = "fog", .model = Interface{}});
  scene.materials.back().interior = {.scattering = {0.4f, 0.1f, 0.7f}};
  check_scene(scene);
  return scene;
}

Scene scene_with_bodies() {
  Scene scene = scene_of_every_model();
  add_models(scene, {Principled{.subsurface_weight = 0.7f, .subsurface_color = {0.9f, 0.5f, 0.4f}},
                     CoatedDiffuse{.roughness = {0.1f, 0.4f}}});
  float radius = 0.02f;
  for (Material& material : scene.materials) {
    const auto* const principled = std::get_if<Principled>(&material.model);
    const bool has_body = principled && principled->subsurface_weight > 0;
    if (!std::holds_alternative<CoatedDiffuse>(material.model) && !has_body) continue;
    material.subsurface = {{radius, 2 * radius, 0.3f * radius}, 0.5f - radius};
    radius *= 3;
  }
  const auto last = std::uint32_t(scene.materials.size() - 1);
  add_models(scene, {Mix{last, last - 1, 0.5f}, Mix{0, last, 0.5f}, Interface{}});
  scene.materials.back().interior = {.absorption = {0.1f, 0.2f, 0.1f}, .scattering = {0.2f, 0.1f, 0.7f}};
  for (std::uint32_t material = last - 1; material < scene.materials.size(); ++material)
    add_ball(scene, material, {{0.3f * float(material % 5) - 0.6f, 0, -0.2f * float(material % 3)}, 0.4f});
  check_scene(scene);
  return scene;
}

Scene scene_of_many_lights() {
  Scene scene = scene_of(soup(60, 0.7f, 3), {0.8f, 0.7f, 0.6f}, {0, 0.3f, 1.6f}, {0, 0, 0});
  add_models(scene, {DiffuseTransmission{}, Dielectric{.ior = 1.5f, .roughness = {0.3f, 0.2f}}});
  Random random(8);
  for (int i = 0; i < 15; ++i) {
    const Vec3 place = random.in_ball() * 1.4f;
    Mesh lamp = lamp_of_kind(i % 5);
    for (Vec3& p : lamp.positions) p = p + place;
    add_lamp(scene, std::move(lamp), {3, 2, float(i)}, EmissionSide(i % 3));
    if (i >= 7) continue;
    const Vec3 center = random.in_ball() * 1.3f;
    add_lamp(scene, SphereSet{"ball", {{center, 0.1f}}}, {2, 2, 2}, EmissionSide::front);
    add_light(scene, PointLight{random.in_ball(), {0.1f, 0.2f, 0.3f}, {}});
    add_light(scene, SpotLight{random.in_ball(), {0, -1, 0}, {1, 1, 1}, {}, 70, 2});
  }
  add_light(scene, EnvironmentLight{random_sky()});
  return scene;
}

Scene textured(Scene scene, TextureFilter filter) {
  add_uvs(scene);
  const ImageTexture image{
      std::make_shared<const MipMap>(*random_square()), WrapMode::repeat, filter, {{{7, 1, 0}, {0, 5, 0}}}};
  ImageTexture second = image;
  second.coordinates = CoordinateSet::second;
  scene.textures = {
      {"", ConstantTexture{{0.2f, 0.6f, 0.9f}}},
      {"", image},
      {"", CheckerboardTexture{0, 1, {{{4, 0, 0}, {0, 4, 0}}}}},
      {"", second},
      {"", NoiseTexture{.pattern = NoisePattern::marble, .scale = 9}},
      {"", NoiseTexture{.pattern = NoisePattern::wrinkled}},
      {"", PlacedTexture{5, TexturePlacement::space, {{{7, 0, 1, 0}, {0, 8, 0, 0}, {1, 0, 9, 0}}}}},
      {"", DirectionMixTexture{6, 3}},
      {"", PlacedTexture{1, TexturePlacement::spherical, {}}}};
  constexpr std::uint32_t cycle[] = {1, 8, 2, 4, 3, 7};
  std::size_t next = 0;
  for (Material& material : scene.materials)
    for (int i = 0; i < material_inputs; ++i)
      if (const auto input = MaterialInput(i); has_input(material.model, input))
        material.textures.push_back({input, cycle[next++ % 6]});
  for (Light& light : scene.lights)
    if (auto* const mesh = std::get_if<MeshLight>(&light.source)) mesh->picture = random_square();
  check_scene(scene);
  return scene;
}

Scene mapped(Scene scene) {
  constexpr std::uint32_t picture = 1;
  for (std::size_t i = 0; i < scene.materials.size(); ++i)
    (i % 3 == 0 ? scene.materials[i].bump_map : scene.materials[i].normal_map) = picture;
  check_scene(scene);
  return scene;
}

}  // namespace twinray::test
