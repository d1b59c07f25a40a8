// SPDX-License-Identifier: Apache-2.0
// Colours and alphas that meshes have at their vertices: written as glTF and read again.
#include "io/vertex_colors.h"

#include <cmath>

#include "core/alpha_test.h"
#include "tests/support/catch.h"
#include "tests/support/round_trip.h"

namespace twinray::test {
namespace {

constexpr float color_rounding = 1e-6f;

Mesh bare_triangle() {
  return {.name = "triangle", .positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .triangles = {{0, 1, 2}}};
}

/// Sets its coordinates to where in a picture its vertices are drawn.
Scene drawn(Mesh mesh, std::vector<Texture> textures, std::uint32_t alpha) {
  set_drawn_uvs(mesh);
  Scene scene = scene_of(mesh, Lambert{});
  scene.textures = std::move(textures);
  scene.bindings[0].alpha = alpha;
  std::vector<Shape> shapes = scene.geometry->shapes();
  scene.geometry =
      std::make_shared<const Geometry>(cut_out(std::move(shapes), scene.bindings, scene.textures));
  return scene;
}

RoundTrip written(const Scene& scene) {
  RoundTrip trip = round_trip(scene, "a.gltf");
  CHECK(trip.warnings.empty());
  CHECK(trip.text.find("images") == std::string::npos);
  return trip;
}

/// Of a triangle of the only mesh, by barycentric coordinates.
Vec2 uv_at(const Scene& scene, std::size_t triangle, const Vec2& part) {
  const Mesh& mesh = *scene.geometry->mesh(0);
  const auto& [a, b, c] = mesh.uv_indices[triangle];
  return mesh.uvs[a] * (1 - part.x - part.y) + mesh.uvs[b] * part.x + mesh.uvs[c] * part.y;
}

}  // namespace

TEST_CASE("written gltf: one color for all vertices is the material's, which needs no coordinates") {
  const Rgb color{0.5f, 0.25f, 0.125f};
  Scene scene = scene_of(bare_triangle(), Lambert{white});
  scene.textures = {{"", ConstantTexture{color}}};
  scene.materials[0].textures.push_back({MaterialInput::reflectance, 0});
  const RoundTrip trip = written(scene);
  CHECK(trip.scene.geometry->mesh(0)->uvs.empty());
  CHECK(trip.scene.materials[0].textures.empty());
  CHECK(std::get<Principled>(trip.scene.materials[0].model).base_color == color);
}

TEST_CASE("written gltf: colors and alphas of vertices are those of vertices again") {
  Mesh mesh = bare_triangle();
  mesh.positions.push_back({1, 1, 1});
  mesh.triangles.push_back({1, 3, 2});
  const Rgb corners[] = {{1, 0, 0}, {0, 0.5f, 0}, {0.25f, 0, 1}, {0.125f, 1, 0.5f}};
  const ImageTexture colors = draw_vertices(mesh, [&](std::uint32_t i) { return corners[i]; });
  const ImageTexture alphas = draw_vertices(mesh, [](std::uint32_t i) { return white * (0.25f * float(i)); });
  Scene scene = drawn(mesh, {{"colors", colors}, {"alphas", alphas}}, 1);
  scene.materials[0].textures.push_back({MaterialInput::reflectance, 0});
  const RoundTrip trip = written(scene);
  REQUIRE(trip.scene.geometry->mesh(0)->uv_indices.size() == 2);
  for (std::size_t t = 0; t < 2; ++t)
    for (const Vec2 part : {Vec2{0, 0}, {1, 0}, {0.25f, 0.5f}}) {
      const auto value = [&](const Scene& of, std::uint32_t texture) {
        return evaluate(of.textures, texture, {.uv = uv_at(of, t, part), .footprint = 10, .is_smooth = true});
      };
      const Rgb was = value(scene, 0), is = value(trip.scene, only_material(trip).textures[0].texture);
      CHECK(max_component(was - is) <= color_rounding);
      CHECK(max_component(is - was) <= color_rounding);
      CHECK(std::fabs(value(trip.scene, trip.scene.bindings[0].alpha).r - value(scene, 1).r) <=
            color_rounding);
    }
}

TEST_CASE("written gltf: what vertices have stays theirs through exchange form, other pictures do not") {
  Mesh mesh = bare_triangle();
  const ImageTexture colors = draw_vertices(mesh, [](std::uint32_t i) { return white * (0.3f * float(i)); });
  for (const bool of_vertices : {true, false}) {
    Scene scene = drawn(mesh, {{"colors", colors}}, no_texture);
    scene.materials[0].textures.push_back({MaterialInput::reflectance, 0});
    std::get<ImageTexture>(scene.textures[0].model).of_vertices = of_vertices;
    const Scene exchanged = round_trip(scene, "a.json").scene;
    CHECK(std::get<ImageTexture>(exchanged.textures[0].model).of_vertices == of_vertices);
    const std::string text = round_trip(exchanged, "a.gltf").text;
    CHECK((text.find("COLOR_0") != std::string::npos) == of_vertices);
    CHECK((text.find("images") != std::string::npos) == !of_vertices);
    const std::vector<std::string> warnings = round_trip(exchanged, "a.pbrt").warnings;
    CHECK(warnings.empty() == !of_vertices);
  }
}

TEST_CASE("written gltf: a limit of the alphas of vertices comes back as one") {
  const Mesh mesh = bare_triangle();
  const ImageTexture alphas = draw_vertices(mesh, [](std::uint32_t i) { return white * (0.5f * float(i)); });
  constexpr float limit = 0.35f, steep = 4096;
  const Scene scene = drawn(mesh,
                            {{"", alphas},
                             {"", ConstantTexture{{1 - steep * limit, 0, 0}}},
                             {"", ConstantTexture{{1 - steep * limit + steep, 0, 0}}},
                             {"", MixTexture{1, 2, 0}}},
                            3);
  const RoundTrip trip = written(scene);
  for (const Vec2 part : {Vec2{0.2f, 0.1f}, {0.5f, 0.05f}, {0.6f, 0.2f}, {0.1f, 0.8f}}) {
    const auto alpha = [&](const Scene& of) {
      return alpha_at(of.textures, of.bindings[0].alpha, {.uv = uv_at(of, 0, part)});
    };
    CHECK(alpha(scene) == (0.5f * part.x + part.y > limit ? 1 : 0));
    CHECK(alpha(trip.scene) == alpha(scene));
  }
}

}  // namespace twinray::test
