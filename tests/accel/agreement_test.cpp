// SPDX-License-Identifier: Apache-2.0
// Every canonical engine against brute force, bit for bit, over geometry and rays chosen to make them differ.
#include <functional>

#include "tests/support/agreement.h"
#include "tests/support/catch.h"
#include "tests/support/cut_outs.h"
#include "tests/support/shapes.h"

using namespace twinray;
using namespace twinray::test;

namespace {

Rays concatenate(Rays a, const Rays& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// Rays along the axes, through corners, edges' middles and insides of triangles, with zeros of both signs.
Rays axis_rays(const Mesh& mesh, int count, std::uint64_t seed) {
  Random random(seed);
  Rays rays;
  for (int i = 0; i < count; ++i) {
    const Triangle& triangle = mesh.triangles[std::size_t(random.below(int(mesh.triangles.size())))];
    const Vec3 &a = mesh.positions[triangle[0]], &b = mesh.positions[triangle[1]];
    const Vec3 target = random.below(2) ? a : a * 0.5f + b * 0.5f;
    const int axis = random.below(3);
    Ray ray{.origin = target};
    for (int other = 0; other < 3; ++other) ray.direction[other] = random.below(2) ? 0.0f : -0.0f;
    ray.direction[axis] = random.below(2) ? 1.0f : -1.0f;
    ray.origin[axis] -= 3 * ray.direction[axis];
    rays.push_back(ray);
  }
  return rays;
}

/// Rays from within or around the mesh exactly at vertices and at middles of edges.
Rays feature_rays(const Mesh& mesh, const Vec3& from, int count, std::uint64_t seed) {
  Random random(seed);
  Rays rays;
  for (int i = 0; i < count; ++i) {
    const Triangle& triangle = mesh.triangles[std::size_t(random.below(int(mesh.triangles.size())))];
    const Vec3 &a = mesh.positions[triangle[0]], &b = mesh.positions[triangle[1]];
    const float s = random.unit();
    const Vec3 target = random.below(2) ? a : a * s + b * (1 - s);
    rays.push_back({.origin = from, .direction = target - from});
  }
  return rays;
}

void scale(Mesh& mesh, float factor) {
  for (Vec3& p : mesh.positions) p = p * factor;
}

}  // namespace

TEST_CASE("engines agree on triangle soups and spheres") {
  const Mesh large = soup(60, 1, 1), small = soup(400, 0.1f, 2);
  const auto geometry = share({small, random_spheres(40, 0.3f, 3), large});
  const Rays rays = concatenate(random_rays(3000, geometry->bounds(), 4), axis_rays(small, 1000, 5));
  CHECK(check_agreement(geometry, rays) > 1000);
}

TEST_CASE("engines agree on slivers") {
  Random random(21);
  Mesh mesh;
  for (int i = 0; i < 300; ++i) {
    const Vec3 a = random.in_cube(), along = random.in_cube(), across = random.in_cube(1e-5f);
    add_triangle(mesh, a, a + along, a + along * 0.5f + across);
  }
  const Rays rays = concatenate(random_rays(1500, {{-1, -1, -1}, {1, 1, 1}}, 22),
                                feature_rays(mesh, {2, 0.5f, 0.1f}, 1500, 23));
  CHECK(check_agreement(share({mesh}), rays) > 500);
}

TEST_CASE("engines agree that a triangle without area is never hit") {
  Mesh mesh = soup(100, 0.5f, 25);
  Random random(26);
  for (int i = 0; i < 100; ++i) {
    const Vec3 a = random.in_cube(), along = random.in_cube();
    add_triangle(mesh, a, a, a + along);
    add_triangle(mesh, {a.x, 0, 0}, {a.y, 0, 0}, {a.z, 0, 0});
  }
  const auto geometry = share({mesh});
  const Rays rays = concatenate(random_rays(1000, geometry->bounds(), 27),
                                feature_rays(mesh, {0.5f, 0.7f, -0.2f}, 1000, 28));
  CHECK(check_agreement(geometry, rays) > 300);
}

TEST_CASE("engines agree on coplanar layers and duplicates, where the lowest id wins") {
  Mesh mesh;
  for (int layer = 0; layer < 5; ++layer)
    for (int i = 0; i < 10; ++i)
      for (int j = 0; j < 10; ++j) {
        const float x = float(i), y = float(j), z = float(layer / 2);
        add_triangle(mesh, {x, y, z}, {x + 1, y, z}, {x, y + 1, z});
        add_triangle(mesh, {x + 1, y, z}, {x + 1, y + 1, z}, {x, y + 1, z});
      }
  const auto geometry = share({mesh, mesh, mesh});
  Rays rays = random_rays(1500, geometry->bounds(), 31);
  for (int i = 0; i <= 20; ++i)
    for (int j = 0; j <= 20; ++j)
      rays.push_back({.origin = {float(i) / 2, float(j) / 2, -1}, .direction = {0, -0.0f, 1}});
  CHECK(check_agreement(geometry, rays) > 400);

  const auto brute = build_accelerator(Backend::brute_force, geometry);
  const Hit hit = brute->closest_hit({.origin = {0.25f, 0.25f, -1}, .direction = {0, 0, 1}});
  CHECK(hit.mesh == 0);
  CHECK(hit.primitive == 0);
}

TEST_CASE("engines agree on rays through the vertices and edges of a closed mesh") {
  const Mesh sphere = icosphere_mesh(3);
  const Rays rays = concatenate(feature_rays(sphere, {0, 0, 0}, 1200, 41),
                                concatenate(feature_rays(sphere, {2, 0.3f, -0.4f}, 1200, 42),
                                            feature_rays(sphere, {0.3f, 0.999f, 0.01f}, 600, 43)));
  CHECK(check_agreement(share({sphere}), rays) > 2800);
}

TEST_CASE("engines agree on rays along the faces of boxes") {
  Mesh mesh;
  Random random(51);
  for (int i = 0; i < 200; ++i) {
    const float x = float(random.below(8)), y = float(random.below(8)), z = float(random.below(8));
    const int axis = random.below(3);
    Vec3 corners[3] = {{x, y, z}, {x, y, z}, {x, y, z}};
    corners[1][(axis + 1) % 3] += 1;
    corners[2][(axis + 2) % 3] += 1;
    add_triangle(mesh, corners[0], corners[1], corners[2]);
  }
  Rays rays;
  for (int i = 0; i < 3000; ++i) {
    Ray ray{.origin = {float(random.below(9)), float(random.below(9)), float(random.below(9))}};
    const int axis = random.below(3);
    for (int other = 0; other < 3; ++other) ray.direction[other] = random.below(2) ? 0.0f : -0.0f;
    ray.direction[axis] = random.below(2) ? 1.0f : -1.0f;
    if (random.below(2)) ray.direction[(axis + 1) % 3] = 1;
    if (random.below(2)) ray.origin[axis] -= 8.5f * ray.direction[axis];
    rays.push_back(ray);
  }
  CHECK(check_agreement(share({mesh}), rays) > 500);
}

TEST_CASE("engines agree on rays from far away") {
  const Mesh mesh = soup(300, 0.3f, 61);
  const auto geometry = share({mesh, random_spheres(10, 0.3f, 62)});
  Random random(63);
  Rays rays;
  for (const float distance : {5.0f, 20.0f, 1e3f, 1e5f, 1e7f})
    for (int i = 0; i < 800; ++i) {
      const Vec3 origin = normalize(random.in_ball()) * distance;
      const Vec3 target = random.in_cube();
      rays.push_back({.origin = origin, .direction = target - origin});
    }
  CHECK(check_agreement(geometry, rays) > 1500);
}

TEST_CASE("engines agree where some vertices lie far outside") {
  Mesh mesh = soup(300, 0.3f, 71);
  Random random(72);
  for (Vec3& p : mesh.positions)
    if (random.below(100) == 0) p = random.in_cube(1e7f);
  const Rays rays = concatenate(random_rays(2000, {{-1, -1, -1}, {1, 1, 1}}, 73),
                                random_rays(500, {{-1e7f, -1e7f, -1e7f}, {1e7f, 1e7f, 1e7f}}, 74));
  CHECK(check_agreement(share({mesh}), rays) > 500);
}

TEST_CASE("engines agree at any scale") {
  for (const float factor : {1e-37f, 1e-30f, 1e-12f, 1e-6f, 1e6f, 2e11f}) {
    CAPTURE(factor);
    Mesh mesh = soup(300, 0.3f, 81);
    scale(mesh, factor);
    const auto geometry = share({mesh});
    Rays rays = concatenate(random_rays(1000, geometry->bounds(), 82), feature_rays(mesh, {}, 500, 83));
    CHECK(check_agreement(geometry, rays) > 500);
  }
}

TEST_CASE("engines agree on fine detail at large coordinates") {
  Mesh mesh = soup(300, 0.3f, 85);
  for (Vec3& p : mesh.positions) p = p * 1e6f + Vec3{7e11f, -3e11f, 9e11f};
  const auto geometry = share({mesh});
  check_agreement(geometry, random_rays(1000, geometry->bounds(), 86));
}

TEST_CASE("engines agree that an invalid ray is a miss") {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const auto geometry = share({icosphere_mesh(1)});
  const Rays rays{{.origin = {nan, 0, 0}, .direction = {1, 0, 0}},
                  {.origin = {0, infinity, 0}, .direction = {1, 0, 0}},
                  {.origin = {0, 0, 2e18f}, .direction = {0, 0, -1}},
                  {.origin = {}, .direction = {0, nan, 1}},
                  {.origin = {}, .direction = {-infinity, 0, 1}},
                  {.origin = {}, .direction = {0, -0.0f, 0}},
                  {.origin = {}, .direction = {1, 0, 0}, .t_min = -1},
                  {.origin = {}, .direction = {1, 0, 0}, .t_min = nan},
                  {.origin = {}, .direction = {1, 0, 0}, .t_min = infinity},
                  {.origin = {}, .direction = {1, 0, 0}, .t_max = nan},
                  {.origin = {}, .direction = {1, 0, 0}, .t_min = 2, .t_max = 1}};
  CHECK(check_agreement(geometry, rays) == 0);
}

TEST_CASE("engines agree that the interval of a ray is closed at both ends") {
  const auto geometry = share({soup(300, 0.4f, 91), random_spheres(20, 0.3f, 92)});
  const auto oracle = build_accelerator(Backend::brute_force, geometry);
  Rays rays;
  int closed = 0;
  for (const Ray& ray : random_rays(800, geometry->bounds(), 93)) {
    const float t = oracle->closest_hit(ray).t;
    if (std::isinf(t)) continue;
    const float before = std::nextafter(t, 0.0f), behind = std::nextafter(t, 1e30f);
    for (const auto& [t_min, t_max] :
         {std::pair{t, t}, {0.0f, t}, {t, 1e30f}, {0.0f, before}, {behind, 1e30f}})
      rays.push_back({.origin = ray.origin, .direction = ray.direction, .t_min = t_min, .t_max = t_max});
    closed += oracle->closest_hit(rays[rays.size() - 5]).t == t;
    closed += oracle->closest_hit(rays[rays.size() - 4]).t == t;
    closed += oracle->closest_hit(rays[rays.size() - 3]).t == t;
    closed += !oracle->any_hit(rays[rays.size() - 2]);
  }
  CHECK(check_agreement(geometry, rays) > 1000);
  CHECK(closed == int(rays.size()) / 5 * 4);
}

TEST_CASE("engines agree on shapes with holes, beside opaque ones") {
  const auto geometry =
      share_cut_out({soup(500, 0.4f, 111), random_spheres(60, 0.4f, 112), soup(100, 0.3f, 113),
                     random_spheres(20, 0.3f, 114), soup(100, 0.3f, 115)},
                    {random_alpha(1), random_alpha(2), constant_alpha(0.5f), constant_alpha(0)});
  Rays rays = concatenate(random_rays(3000, geometry->bounds(), 116),
                          concatenate(feature_rays(*geometry->mesh(0), {2, 0.5f, 0.1f}, 500, 117),
                                      feature_rays(*geometry->mesh(0), {1e7f, 2e7f, 1e7f}, 500, 120)));
  Random random(118);
  for (Ray& ray : rays)  // Some end before, or begin behind, what they would hit.
    if (random.below(4) == 0) (random.below(2) ? ray.t_min : ray.t_max) = random.unit() + 0.3f;
  for (const float length : {1e-20f, 1e20f})
    for (const Ray& ray : random_rays(200, geometry->bounds(), 119))
      rays.push_back({.origin = ray.origin, .direction = ray.direction * length});
  CHECK(check_agreement(geometry, rays) > 1500);
}

TEST_CASE("engines agree on directions of any length") {
  const auto geometry = share({soup(300, 0.4f, 95), random_spheres(20, 0.3f, 96)});
  Rays rays;
  for (const float length : {1e-44f, 1e-38f, 1e-30f, 1e-13f, 1e-11f, 1e11f, 1e13f, 1e30f, 1e38f})
    for (const Ray& ray : random_rays(200, geometry->bounds(), 97))
      rays.push_back({.origin = ray.origin, .direction = ray.direction * length});
  CHECK(check_agreement(geometry, rays) > 500);
}

TEST_CASE("any hit and closest hit agree where the parameter leaves the range of float") {
  const auto geometry = share({icosphere_mesh(1)});
  // The sphere lies at t = 10^44, which no Hit can name.
  const Ray ray{.origin = {0.1f, 0.2f, 0.3f}, .direction = {1e-44f, 0, 0}};
  CHECK(check_agreement(geometry, {ray}) == 0);
}

TEST_CASE("no tree loses a hit of Moeller and Trumbore's test, whatever its leaves and widths") {
  const auto geometry = share({soup(400, 0.3f, 101), random_spheres(10, 0.2f, 102)});
  const auto engine = [&](BuildOptions options) {
    options.triangle_test = TriangleTest::moller_trumbore;
    return build_accelerator(Backend::bvh, geometry, options);
  };
  const auto one_leaf = engine({.max_leaf_size = 255, .intersection_cost = 1e-6});
  REQUIRE(one_leaf->stats().tree->leaves < 8);
  for (const BuildOptions& options :
       {BuildOptions{.max_leaf_size = 1}, {.bvh_width = 2, .max_leaf_size = 7}}) {
    const auto bvh = engine(options);
    REQUIRE(bvh->stats().tree->leaves > 50);
    for (const Ray& ray : random_rays(1000, geometry->bounds(), 103)) {
      const Hit hit = one_leaf->closest_hit(ray);
      REQUIRE(same_bits(bvh->closest_hit(ray), hit));
      REQUIRE(bvh->any_hit(ray) == bool(hit));
    }
  }
}

TEST_CASE("Moeller and Trumbore's test finds the canonical hit but for its rounding") {
  const auto geometry = share({soup(400, 0.3f, 105)});
  const auto woop = build_accelerator(Backend::bvh, geometry);
  const auto other =
      build_accelerator(Backend::bvh, geometry, {.triangle_test = TriangleTest::moller_trumbore});
  constexpr double rounding = 1e-3;  // Both tests lose digits at grazing angles.
  int hits = 0;
  for (const Ray& ray : random_rays(1000, geometry->bounds(), 106)) {
    const Hit expected = woop->closest_hit(ray), found = other->closest_hit(ray);
    REQUIRE(found.primitive == expected.primitive);
    REQUIRE(bool(found) == bool(expected));
    if (expected) REQUIRE(found.t == Approx(expected.t).epsilon(rounding));
    hits += bool(expected);
  }
  CHECK(hits > 300);
}

TEST_CASE("a batch gives the answers of its rays") {
  const auto geometry = share_cut_out({soup(200, 0.4f, 111), soup(100, 0.4f, 113)}, {random_alpha(114)});
  const Rays rays = random_rays(200, geometry->bounds(), 112);
  for (const LabelledEngine& engine : canonical_engines(geometry)) {
    std::vector<Hit> hits(rays.size());
    std::vector<std::uint8_t> found(rays.size());
    engine.accelerator->closest_hits(rays, hits);
    engine.accelerator->any_hits(rays, found);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      CHECK(same_bits(hits[i], engine.accelerator->closest_hit(rays[i])));
      CHECK(bool(found[i]) == engine.accelerator->any_hit(rays[i]));
    }
  }
}
