// SPDX-License-Identifier: Apache-2.0
// Normal maps and bump maps: against real geometry, against closed forms, and the same bits from waves and
// all engines; and the tangent of unequal widths.
#include <cmath>

#include "core/random.h"
#include "core/shading_map.h"
#include "integrators/interaction.h"
#include "integrators/path_reference.h"
#include "tests/support/catch.h"
#include "tests/support/engines.h"
#include "tests/support/estimate.h"
#include "tests/support/scenes.h"
#include "tests/support/shapes.h"

namespace twinray::test {
namespace {

constexpr int teeth = 16;

Texture picture_of(Image image, TextureFilter filter) {
  ImageTexture texture{.image = std::make_shared<const MipMap>(std::move(image))};
  texture.filter = filter;
  return {"map", texture};
}

Texture constant(const Rgb& value) { return {"map", ConstantTexture{value}}; }

Rgb encoded(const Vec3& n) { return {0.5f + 0.5f * n.x, 0.5f + 0.5f * n.y, 0.5f + 0.5f * n.z}; }

/// A square [-1, 1]^2 at y = 0, u along x and v along -z.
Mesh mapped_square() {
  Mesh mesh = floor_square(1, 0);
  mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh.uv_indices = mesh.triangles;
  return mesh;
}

/// The square's ridges: they rise and fall along x by this slope.
Mesh ridges(float slope) {
  Mesh mesh;
  const float tooth = 1 / float(teeth);
  for (int i = 0; i < 2 * teeth; ++i) {
    const float x0 = float(i) * tooth - 1, x1 = x0 + tooth;
    const float y0 = i % 2 ? slope * tooth : 0, y1 = i % 2 ? 0 : slope * tooth;
    add_triangle(mesh, {x0, y0, 1}, {x1, y1, 1}, {x1, y1, -1});
    add_triangle(mesh, {x0, y0, 1}, {x1, y1, -1}, {x0, y0, -1});
  }
  return mesh;
}

/// Their normals, as a picture.
Texture ridge_map(float slope) {
  Image image(2 * teeth, 1);
  for (int i = 0; i < 2 * teeth; ++i) image.at(i, 0) = encoded(normalize({i % 2 ? slope : -slope, 0, 1}));
  return picture_of(std::move(image), TextureFilter::nearest);
}

/// A mesh seen from straight above, all of it, without perspective, in a light from this direction.
Scene lit(Mesh mesh, const Vec3& towards_light) {
  Scene scene = scene_of(std::move(mesh), {0.8f, 0.8f, 0.8f}, {0, 2, 0}, {0, 0, 0});
  scene.camera.projection = Projection::orthographic;
  scene.camera.tan_half_width = scene.camera.tan_half_height = 1;
  add_light(scene, DirectionalLight{-normalize(towards_light), {1, 1, 1}});
  return scene;
}

void set_normal_map(Scene& scene, const Texture& map) {
  scene.materials[0].normal_map = std::uint32_t(scene.textures.size());
  scene.textures.push_back(map);
  check_scene(scene);
}
void set_bump_map(Scene& scene, const Texture& map) {
  scene.materials[0].bump_map = std::uint32_t(scene.textures.size());
  scene.textures.push_back(map);
  check_scene(scene);
}

/// Random normals, none far from n.
Texture rough_map() {
  Random random(9);
  Image image(16, 16);
  for (Rgb& texel : image.pixels)
    texel = encoded(normalize({random.unit() - 0.5f, random.unit() - 0.5f, 0.7f}));
  return picture_of(std::move(image), TextureFilter::bilinear);
}

Texture rough_heights() {
  Random random(10);
  Image image(16, 16);
  for (Rgb& texel : image.pixels) texel = {0.05f * random.unit(), 0, 0};
  return picture_of(std::move(image), TextureFilter::bilinear);
}

/// Surfaces of several models with maps, with and without coordinates, balls among them, and lamps.
Scene scene_of_maps() {
  Scene scene = scene_of(mapped_square(), {0.8f, 0.7f, 0.3f}, {0, 1.3f, 1.6f}, {0, 0, 0});
  add_lamp(scene, floor_square(0.5f, 1.2f), {3, 2, 1}, EmissionSide::both);
  add_lamp(scene, SphereSet{"bulb", {{{0.3f, 0.8f, 0.4f}, 0.2f}}}, {2, 2, 2}, EmissionSide::front);
  add_light(scene, PointLight{{0.3f, 0.2f, 0.1f}, {0.1f, 0.2f, 0.3f}, {}});
  add_light(scene, AmbientLight{{0, 1, 0}, {0.1f, 0.2f, 0.1f}});
  scene.textures = {rough_map(), rough_heights()};
  std::vector<Shape> shapes = scene.geometry->shapes();
  const SurfaceModel models[] = {Conductor{.roughness = {0.1f, 0.4f}},  Mirror{},  CoatedDiffuse{},
                                 Dielectric{.roughness = {0.2f, 0.1f}}, Lambert{}, DiffuseTransmission{}};
  Random random(4);
  for (const SurfaceModel& model : models) {
    Material material{"", model};
    if (is_anisotropic(model)) material.tangent_map = 0, material.tangent_degrees = -50;
    const bool is_even = scene.materials.size() % 2 == 0;
    if (is_even)
      material.normal_map = 0;
    else
      material.bump_map = 1;
    scene.materials.push_back(material);
    Mesh mesh = soup(6, 0.5f, std::uint64_t(random.below(1000)));
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
      mesh.uvs.push_back({random.unit(), random.unit()});
    mesh.uv_indices = mesh.triangles;
    shapes.push_back(std::move(mesh));
    shapes.push_back(SphereSet{"", {{random.in_ball(), 0.25f}}});
    shapes.push_back(soup(2, 0.5f, 3));  // Without coordinates.
    scene.bindings.insert(scene.bindings.end(), 3, {std::uint32_t(scene.materials.size() - 1)});
  }
  scene.geometry = std::make_shared<const Geometry>(std::move(shapes));
  scene.materials[0].normal_map = 0;
  check_scene(scene);
  return scene;
}

/// The interaction in the middle of a scene's first triangle, seen from above.
Interaction middle_of(const Scene& scene, const BsdfTable& bsdfs, const Vec3& wo) {
  return {bsdfs, surface_at(*scene.geometry, {.t = 1, .u = 0.3f, .v = 0.3f}), wo};
}

}  // namespace

TEST_CASE("a flat map changes no bit of a picture") {
  const Scene plain = lit(mapped_square(), {0.3f, 1, 0.2f});
  const RenderOptions picture{.width = 16, .height = 16, .samples = 8, .threads = 1};
  const PathOptions path{.max_depth = 3};
  const RenderResult expected = render_with(plain, PathIntegrator(plain, path), picture);
  Scene mapped = plain;
  set_normal_map(mapped, constant({0.5f, 0.5f, 1}));
  CHECK(same_bits(render_with(mapped, PathIntegrator(mapped, path), picture).film, expected.film));
  Scene raised = plain;
  set_bump_map(raised, constant({0.3f, 0.3f, 0.3f}));
  CHECK(same_bits(render_with(raised, PathIntegrator(raised, path), picture).film, expected.film));
}

TEST_CASE("ridges of a normal map are as bright as real ones, in light that reaches all of them") {
  // Steeper than their slope: no ridge shades another, and next to nothing is softened.
  for (const float slope : {0.2f, 0.5f}) {
    const Vec3 light{0.5f * slope, 1, 0};
    const Scene real = lit(ridges(slope), light);
    Scene mapped = lit(mapped_square(), light);
    const PathOptions path{.max_depth = 1};
    const double flat = estimate(mapped, path, small_picture(1024)).mean;
    set_normal_map(mapped, ridge_map(slope));
    const Estimate expected = estimate(real, path, small_picture(1024));
    const Estimate found = estimate(mapped, path, small_picture(1024));
    check_same_mean(found, expected, 0.02);
    // Half the ridges are seen in each of two brightnesses, which their variance shows.
    CHECK(found.standard_error == Approx(expected.standard_error).epsilon(0.05));
    CHECK(expected.standard_error > 10 * render_rounding * flat);
  }
}

TEST_CASE("a bump map that rises evenly shades as a plane that rises so") {
  // A picture of 0 and 1 rises between the middles of its two pixels by 2 a unit of u: by 1 a unit of length.
  Image image(2, 1);
  image.at(1, 0) = {1, 1, 1};
  Texture ramp = picture_of(std::move(image), TextureFilter::bilinear);
  std::get<ImageTexture>(ramp.model).wrap = WrapMode::clamp;
  Scene scene = lit(mapped_square(), {0, 1, 0});
  set_bump_map(scene, ramp);
  const BsdfTable bsdfs(scene);
  const auto point = surface_at(*scene.geometry, {.t = 1, .u = 0.1f, .v = 0.4f});
  REQUIRE(point.uv.x == Approx(0.5));
  const Interaction at(bsdfs, point, {0, 1, 0});
  const Vec3 expected = normalize({-1, 1, 0});
  CHECK(length(at.normal() - expected) < 1e-3f);
  // Seen from below it is the other side of the same surface.
  CHECK(length(Interaction(bsdfs, point, normalize({0.2f, -1, 0})).normal() + expected) < 1e-3f);
}

TEST_CASE("a bump map in space rises as one by texture coordinates") {
  // Its height is three times x, wherever the coordinates are.
  Scene scene = lit(mapped_square(), {0, 1, 0});
  scene.textures = {{"ramp", BilinearTexture{.v10 = {1, 1, 1}, .v11 = {1, 1, 1}}}};
  set_bump_map(scene,
               {"along x", PlacedTexture{0, TexturePlacement::planar, {{{3, 0, 0, 0}, {0, 0, 1, 0}}}}});
  const BsdfTable bsdfs(scene);
  const auto point = surface_at(*scene.geometry, {.t = 1, .u = 0.3f, .v = 0.2f});
  const Interaction at(bsdfs, point, {0, 1, 0});
  CHECK(length(at.normal() - normalize({-3, 1, 0})) < 1e-3f);
}

TEST_CASE("red of a normal map points along u, green along v, blue along the normal, on both sides") {
  Scene scene = lit(mapped_square(), {0, 1, 0});
  set_normal_map(scene, constant(encoded(normalize({0.3f, 0.5f, 1}))));
  const BsdfTable bsdfs(scene);
  const Vec3 expected = normalize({0.3f, 1, -0.5f});
  CHECK(length(middle_of(scene, bsdfs, {0, 1, 0}).normal() - expected) < 1e-6f);
  CHECK(length(middle_of(scene, bsdfs, {0, -1, 0}).normal() + expected) < 1e-6f);
}

TEST_CASE("of light from below the true surface a map shows none, whatever its normals") {
  Scene scene = lit(mapped_square(), {0, 1, 0});
  Random random(6);
  set_normal_map(scene, constant({1, 0.5f, 0.7f}));
  for (const Rgb& color : {Rgb{1, 0.5f, 0.7f}, {0, 0, 0}, {0.5f, 1, 0.5f}, {1, 0, 1}, {-9, 3, 1e30f}}) {
    scene.textures[0] = constant(color);
    const BsdfTable bsdfs(scene);
    int lit_ones = 0;
    for (int i = 0; i < 2000; ++i) {
      const Vec3 wo = normalize(random.in_ball()), wi = normalize(random.in_ball());
      const Interaction at = middle_of(scene, bsdfs, wo);
      const Rgb scattered = at.scattered(wi).value;
      REQUIRE(is_finite(scattered));
      if (wo.y * wi.y <= 0) REQUIRE(is_black(scattered));
      // Softening takes, it never gives.
      REQUIRE(scattered.r <= 0.8 / pi * std::fabs(dot(at.normal(), wi)) * (1 + render_rounding));
      lit_ones += !is_black(scattered);
    }
    CHECK(lit_ones > 400);
  }
}

TEST_CASE("at the end of what the geometry sees light falls to nothing, instead of breaking off") {
  Scene scene = lit(mapped_square(), {0, 1, 0});
  set_normal_map(scene, constant(encoded(normalize({1, 0, 1}))));
  const BsdfTable bsdfs(scene);
  const Interaction at = middle_of(scene, bsdfs, {0, 1, 0});
  const auto scattered = [&](float height) {
    return double(at.scattered(normalize({1, height, 0})).value.r);
  };
  const double whole = 0.8 / double(pi);
  CHECK(scattered(1e-4f) < 0.001 * whole);  // 0.71 of it without softening.
  // From straight above nothing is taken: 45 degrees from the normal.
  CHECK(double(at.scattered({0, 1, 0}).value.r) == Approx(whole * std::sqrt(0.5)));
  double before = 0;
  for (float height = 0.01f; height <= 1; height += 0.01f) {
    REQUIRE(scattered(height) > before);
    before = scattered(height);
  }
}

TEST_CASE("softening costs this part of the light of an even sky, by how far the map leans") {
  // What is lost where the geometry sees no sky is 1 - (1 + cos) / 2; the rest is the price of the softness.
  const std::pair<float, double> kept[] = {{10, 0.9844}, {20, 0.9429}, {30, 0.8787}, {45, 0.7437}};
  for (const auto& [degrees, expected] : kept) {
    Scene scene = scene_of(mapped_square(), {1, 1, 1}, {0, 2, 0}, {0, 0, 0});
    scene.camera.tan_half_width = scene.camera.tan_half_height = 1e-4f;
    add_light(scene, AmbientLight{{0, 1, 0}, {1, 1, 1}});
    const float angle = degrees * pi / 180;
    set_normal_map(scene, constant(encoded({std::sin(angle), 0, std::cos(angle)})));
    check_mean(estimate(scene, {.max_depth = 1}, small_picture(20000)), expected, 0.02);
  }
}

TEST_CASE("what a mirror with a map shows is softened as light samples are") {
  // Leaning by 30 degrees and seen from above, it reflects at 60 degrees: where alpha^2 = 1 / 24 and tan^2
  // = 3.
  Scene scene = scene_of(mapped_square(), {1, 1, 1}, {0, 2, 0}, {0, 0, 0});
  scene.camera.tan_half_width = scene.camera.tan_half_height = 1e-4f;
  scene.materials[0].model = Mirror{};
  add_light(scene, AmbientLight{{0, 1, 0}, {1, 1, 1}});
  set_normal_map(scene, constant(encoded({0.5f, 0, std::sqrt(0.75f)})));
  const double expected = 2 / (1 + std::sqrt(1.125));
  CHECK(estimate(scene, {.max_depth = 1}, small_picture(4)).mean == Approx(expected).epsilon(1e-3));
}

TEST_CASE("a mapped surface is as bright by every way of finding light") {
  for (const SurfaceModel& model :
       {SurfaceModel{Lambert{{0.8f, 0.8f, 0.8f}}}, SurfaceModel{Conductor{.roughness = {0.4f, 0.4f}}}}) {
    Scene scene = scene_of(mapped_square(), {1, 1, 1}, {0, 2, 1}, {0, 0, 0});
    scene.camera.tan_half_width = scene.camera.tan_half_height = 1e-4f;
    scene.materials[0].model = model;
    add_lamp(scene, SphereSet{"bulb", {{{1.5f, 0.5f, 0}, 0.6f}}}, {4, 4, 4}, EmissionSide::front);
    set_normal_map(scene, constant(encoded(normalize({0.7f, 0, 1}))));
    const auto found = [&](DirectMethod method) {
      return estimate(scene, {.max_depth = 1, .direct = method}, small_picture(20000));
    };
    const Estimate expected = found(DirectMethod::lights);
    check_same_mean(found(DirectMethod::mis), expected, 0.03);
    check_same_mean(found(DirectMethod::hemisphere), expected, 0.1);
  }
}

TEST_CASE("facets of unequal widths have their directions from the texture coordinates") {
  const auto scene_with = [](const Roughness& roughness, bool is_turned) {
    Mesh mesh = mapped_square();
    if (is_turned) mesh.uvs = {{0, 0}, {0, 1}, {-1, 1}, {-1, 0}};
    Scene scene = lit(std::move(mesh), {0, 1, 0});
    scene.materials[0].model = Conductor{.roughness = roughness};
    return scene;
  };
  const Scene along = scene_with({0.1f, 0.5f}, false), across = scene_with({0.5f, 0.1f}, true);
  const Scene other = scene_with({0.5f, 0.1f}, false);
  const BsdfTable first(along), second(across), third(other);
  const Vec3 wo = normalize({0.1f, 1, 0.2f});
  double largest = 0;
  for (const Vec3& towards : {Vec3{0.4f, 1, 0}, {0, 1, 0.4f}, {-0.5f, 1, 0.3f}}) {
    const Vec3 wi = normalize(towards);
    const double value = double(middle_of(along, first, wo).scattered(wi).value.r);
    CHECK(value == Approx(double(middle_of(across, second, wo).scattered(wi).value.r)).epsilon(1e-4));
    largest =
        std::max(largest, std::fabs(value / double(middle_of(other, third, wo).scattered(wi).value.r) - 1));
  }
  CHECK(largest > 0.5);
  // Facets are wide along v, which is z: light from there is scattered to the viewer.
  CHECK(middle_of(along, first, {0, 1, 0}).scattered(normalize({0, 1, 0.8f})).value.r >
        5 * middle_of(along, first, {0, 1, 0}).scattered(normalize({0.8f, 1, 0})).value.r);
}

TEST_CASE("between two pixels a map's direction lies between theirs, whatever the filter") {
  Scene scene = lit(mapped_square(), {0, 1, 0});
  Image image(2, 1);
  image.at(0, 0) = encoded(normalize({1, 0, 1}));
  image.at(1, 0) = encoded(normalize({-1, 0, 1}));
  scene.materials[0].model = Conductor{.roughness = {0.1f, 0.5f}};
  set_normal_map(scene, picture_of(std::move(image), TextureFilter::stochastic));
  SurfacePoint point = surface_at(*scene.geometry, {.t = 1, .u = 0.3f, .v = 0.3f});
  point.uv = {0.5f, 0.5f};
  scene.materials[0].tangent_map = scene.materials[0].normal_map;
  for (const float draw : {0.01f, 0.3f, 0.7f, 0.99f}) {
    point.texture_draw = {draw, draw};
    CHECK(length(mapped_normal(scene, scene.materials[0], point) - point.shading_normal) < 1e-6f);
    CHECK(length(facet_tangent(scene, scene.materials[0], point, {1, 0, 0}) - Vec3{1, 0, 0}) < 1e-6f);
  }
}

TEST_CASE("the tangent of facets is turned from dp/du towards n x dp/du, and so is that of a map") {
  Scene scene = lit(mapped_square(), {0, 1, 0});
  scene.textures = {constant({0.5f, 1, 0}), constant({0.5f, 0.5f, 1}), constant({0, 0.5f, 0})};
  Material& metal = scene.materials[0];
  metal.model = Conductor{.roughness = {0.1f, 0.5f}};
  const SurfacePoint point = surface_at(*scene.geometry, {.t = 1, .u = 0.3f, .v = 0.3f});
  const auto tangent = [&](float degrees, std::uint32_t map) {
    metal.tangent_degrees = degrees, metal.tangent_map = map;
    check_scene(scene);
    return normalize(facet_tangent(scene, metal, point, {2, 0, 0}));
  };
  const Vec3 x{1, 0, 0}, v{0, 0, -1};  // dp/du, and n x dp/du.
  const float c = std::cos(pi / 6), s = std::sin(pi / 6);
  const auto check = [](const Vec3& found, const Vec3& expected) { CHECK(length(found - expected) < 1e-6f); };
  check(tangent(0, no_texture), x);
  check(tangent(30, no_texture), x * c + v * s);
  check(tangent(-30, no_texture), x * c - v * s);
  check(tangent(-360, no_texture), x);
  check(tangent(360, no_texture), x);
  check(tangent(0, 0), v);
  check(tangent(30, 0), v * c - x * s);
  check(tangent(30, 1), x * c + v * s);
  check(tangent(0, 2), -x);
}

TEST_CASE("facets whose tangent is turned are those of texture coordinates that are turned the other way") {
  const auto scene_of_uvs = [](float turned_by) {
    Mesh mesh = mapped_square();
    const float c = std::cos(turned_by * pi / 180), s = std::sin(turned_by * pi / 180);
    for (Vec2& uv : mesh.uvs) uv = {c * uv.x - s * uv.y, s * uv.x + c * uv.y};
    Scene scene = lit(std::move(mesh), {0, 1, 0});
    scene.materials[0].model =
        Principled{.base_metalness = 1, .specular_roughness = 0.5f, .specular_roughness_anisotropy = 0.8f};
    return scene;
  };
  const Scene turned_uvs = scene_of_uvs(-35), plain = scene_of_uvs(0);
  Scene turned = plain, mapped = plain;
  turned.materials[0].tangent_degrees = 35;
  mapped.textures = {constant(encoded(normalize({std::cos(55 * pi / 180), std::sin(55 * pi / 180), 0})))};
  mapped.materials[0].tangent_map = 0, mapped.materials[0].tangent_degrees = -20;
  const BsdfTable first(turned_uvs), second(turned), third(mapped), fourth(plain);
  double largest = 0;
  // From below, too: the turn is that of the surface, not of its side.
  for (const Vec3& wo : {normalize({0.1f, 1, 0.2f}), normalize({0.3f, -1, 0.1f})})
    for (const Vec3& towards : {Vec3{0.4f, 1, 0}, {0, 1, 0.4f}, {-0.5f, 1, 0.3f}}) {
      const Vec3 wi = normalize(wo.y > 0 ? towards : -towards);
      const double value = double(middle_of(turned_uvs, first, wo).scattered(wi).value.r);
      CHECK(value == Approx(double(middle_of(turned, second, wo).scattered(wi).value.r)).epsilon(1e-4));
      CHECK(value == Approx(double(middle_of(mapped, third, wo).scattered(wi).value.r)).epsilon(1e-4));
      largest = std::max(largest,
                         std::fabs(value / double(middle_of(plain, fourth, wo).scattered(wi).value.r) - 1));
    }
  CHECK(largest > 0.5);
}

TEST_CASE("waves have the reference's bits where surfaces have maps, on every engine") {
  check_waves(scene_of_maps());
}

}  // namespace twinray::test
