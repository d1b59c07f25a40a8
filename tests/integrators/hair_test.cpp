// SPDX-License-Identifier: Apache-2.0
// Fibres as paths meet them: tubes that light goes into and leaves at once.
#include <cmath>

#include "core/elementary.h"
#include "integrators/interaction.h"
#include "integrators/path_reference.h"
#include "tests/support/catch.h"
#include "tests/support/engines.h"
#include "tests/support/estimate.h"
#include "tests/support/scenes.h"

namespace twinray::test {
namespace {

/// A closed tube of eight sides, round by its normals, between two points; its first coordinate runs along
/// it.
void add_tube(Mesh& mesh, const Vec3& from, const Vec3& to, float radius) {
  constexpr std::uint32_t sides = 8;
  const Frame frame(normalize(to - from));
  const auto first = std::uint32_t(mesh.positions.size());
  const auto add = [&](const Vec3& center, std::uint32_t k, float u) {
    const SinCos angle = sincos_turns(float(k % sides) / sides);
    const Vec3 out = frame.tangent * angle.cos + frame.bitangent * angle.sin;
    mesh.positions.push_back(center + out * radius);
    mesh.normals.push_back(out);
    mesh.uvs.push_back({u, float(k) / sides});
  };
  for (std::uint32_t k = 0; k <= sides; ++k) add(from, k, 0), add(to, k, 1);
  for (std::uint32_t k = 0; k < sides; ++k) {
    const std::uint32_t a = first + 2 * k, b = a + 2;
    mesh.triangles.push_back({a, b, b + 1});
    mesh.triangles.push_back({a, b + 1, a + 1});
    if (k == 0) continue;
    mesh.triangles.push_back({first, b, a});
    mesh.triangles.push_back({first + 1, a + 1, b + 1});
  }
}

/// A thicket of fibres in front of a camera that looks along -z.
Scene thicket(const Hair& hair, int layers = 3) {
  Mesh mesh{.name = "hair"};
  for (int i = 0; i < 9; ++i)
    for (int layer = 0; layer < layers; ++layer) {
      const float x = 0.22f * float(i - 4) + 0.07f * float(layer), z = -0.3f * float(layer);
      add_tube(mesh, {x, -2, z}, {x + 0.3f * float(layer - 1), 2, z + 0.05f * float(i % 3)}, 0.1f);
    }
  mesh.normal_indices = mesh.uv_indices = mesh.triangles;
  Scene scene = scene_of({}, {}, {0, 0, 3}, {0, 0, 0});
  scene.geometry = std::make_shared<const Geometry>(std::vector<Shape>{std::move(mesh)});
  scene.materials = {{.name = "hair", .model = hair}};
  scene.bindings = {{0}};
  scene.camera.tan_half_width = scene.camera.tan_half_height = 0.2f;
  return scene;
}

}  // namespace

TEST_CASE("hair that absorbs nothing cannot be seen in a white sky, by every way of finding light") {
  for (const DirectMethod method : all_methods) {
    CAPTURE(int(method));
    Scene scene = thicket({white, 0.4f, 0.4f, 2});
    add_light(scene, constant_sky({1, 1, 1}));
    const PathOptions path{.max_depth = 100, .direct = method, .roulette = {1}};
    check_mean(estimate(scene, path, small_picture(method == DirectMethod::mis ? 128 : 1500)), 1, 0.2);
  }
}

TEST_CASE("all ways of finding light agree on hair before a lamp") {
  Scene scene = thicket({{0.8f, 0.5f, 0.3f}, 0.4f, 0.5f, 3});
  add_lamp(scene, SphereSet{"lamp", {{{1, 1, -4}, 2}}}, {8, 8, 8}, EmissionSide::front);
  const auto seen = [&](DirectMethod method) {
    return estimate(scene, {.max_depth = 2, .direct = method, .roulette = {1}}, small_picture(4096));
  };
  const Estimate mis = seen(DirectMethod::mis);
  check_same_mean(seen(DirectMethod::lights), mis, 0.2);
  check_same_mean(seen(DirectMethod::hemisphere), mis, 0.5);
}

TEST_CASE("a fibre's tangent runs along it, and none of its directions is lost at the sides of its tube") {
  const Scene scene = thicket(Hair{});
  const BsdfTable bsdfs(scene);
  const Hit hit{.t = 1, .u = 0.3f, .v = 0.4f, .primitive = 2};
  const SurfacePoint point = surface_at(*scene.geometry, hit);
  const Mesh& mesh = *scene.geometry->mesh(0);
  const Vec3 along = normalize(mesh.positions[1] - mesh.positions[0]);
  const Interaction at(bsdfs, point, normalize(point.geometric_normal + along * 0.3f));
  CHECK(std::fabs(dot(at.frame().tangent, along)) > 0.9999f);
  // Between the tube's side and the round fibre's.
  const Vec3 between = normalize(at.normal() - point.geometric_normal);
  REQUIRE(std::isfinite(between.x));
  for (const float side : {-1.0f, 1.0f}) {
    const Vec3 wi = normalize(cross(along, at.normal()) * side + point.geometric_normal * 1e-3f);
    CHECK(at.is_consistent(wi));
    CHECK(at.is_consistent(-wi));
    CHECK_FALSE(is_black(at.scattered(wi).value));
  }
}

TEST_CASE("hair has the same bits on all engines, instruction sets and threads") {
  Scene scene = thicket({{0.8f, 0.5f, 0.3f}, 0.3f, 0.3f, 2}, 1);
  add_light(scene, constant_sky({0.5f, 0.6f, 0.7f}));
  add_lamp(scene, SphereSet{"lamp", {{{1, 1, -3}, 1}}}, {8, 8, 8}, EmissionSide::front);
  check_waves(scene);
}

}  // namespace twinray::test
