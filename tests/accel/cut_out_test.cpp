// SPDX-License-Identifier: Apache-2.0
// Shapes with holes: which hits count, and that the least of those is the answer.
#include <cmath>

#include "accel/accelerator.h"
#include "accel/canonical/shape_test.h"
#include "core/error.h"
#include "tests/support/catch.h"
#include "tests/support/cut_outs.h"
#include "tests/support/shapes.h"

using namespace twinray;
using namespace twinray::test;

namespace {

/// Every hit of the ray with a primitive, whether it counts or not: a sphere's second one behind its first.
std::vector<Hit> all_hits(const Geometry& geometry, const Ray& ray) {
  std::vector<Hit> hits;
  CheckedRay checked;
  if (!load_ray(ray, checked)) return hits;
  const auto add = [&](const ShapeHit& hit, PrimitiveId id) {
    hits.push_back({hit.t, hit.u, hit.v, id.primitive, id.mesh, no_instance});
  };
  for (std::uint32_t shape = 0; shape < geometry.shapes().size(); ++shape) {
    ShapeHit hit;
    if (const Mesh* mesh = geometry.mesh(shape))
      for (std::uint32_t i = 0; i < mesh->triangles.size(); ++i) {
        const auto& [a, b, c] = mesh->triangles[i];
        if (intersect_triangle(checked, mesh->positions[a], mesh->positions[b], mesh->positions[c],
                               checked.t_max, hit))
          add(hit, {shape, i});
      }
    else
      for (std::uint32_t i = 0; i < geometry.sphere_set(shape)->spheres.size(); ++i)
        intersect_sphere(checked, geometry.sphere_set(shape)->spheres[i], checked.t_max, hit,
                         [&](const ShapeHit& root) {
                           add(root, {shape, i});
                           return false;
                         });
  }
  return hits;
}

/// How many of `count` rays towards -z over a square of side 2 hit something.
int hits_from_above(const Geometry& geometry, int count) {
  const auto engine = build_accelerator(Backend::bvh, std::make_shared<const Geometry>(geometry));
  Random random(5);
  int hits = 0;
  for (int i = 0; i < count; ++i) {
    const float x = random.unit() * 2 - 1, y = random.unit() * 2 - 1;
    hits += engine->any_hit({.origin = {x, y, 5}, .direction = {0, 0, -1}});
  }
  return hits;
}

Mesh square(float z) {
  Mesh mesh;
  mesh.positions = {{-1, -1, z}, {1, -1, z}, {1, 1, z}, {-1, 1, z}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

/// Within four standard deviations of a binomial distribution: 6 in 100,000 are not.
void check_part(int hits, int count, double part) {
  CHECK(std::fabs(hits - count * part) < 4 * std::sqrt(count * part * (1 - part)));
}

}  // namespace

TEST_CASE("the closest hit is the least of all that count, and any hit whether there is one") {
  const auto geometry = share_cut_out({soup(200, 0.6f, 1), random_spheres(40, 0.5f, 2), soup(40, 0.5f, 3)},
                                      {random_alpha(4), random_alpha(5)});
  const auto oracle = build_accelerator(Backend::brute_force, geometry);
  int refused = 0, later_roots = 0;
  for (const Ray& ray : random_rays(3000, geometry->bounds(), 6)) {
    Hit least;
    const Hit* nearer = nullptr;
    std::vector<Hit> hits = all_hits(*geometry, ray);
    for (const Hit& hit : hits) {
      const bool counts = geometry->is_opaque(hit.mesh) || geometry->accepts(ray.origin, ray.direction, hit);
      refused += !counts;
      if (counts && precedes(hit, least)) {
        later_roots += nearer && nearer->mesh == 1 && hit.mesh == 1 && nearer->primitive == hit.primitive;
        least = hit;
      }
      nearer = counts ? nullptr : &hit;
    }
    REQUIRE(oracle->closest_hit(ray) == least);
    REQUIRE(oracle->any_hit(ray) == bool(least));
  }
  CHECK(refused > 1000);
  CHECK(later_roots > 50);  // Seen through a hole in the sphere's near side.
}

TEST_CASE("of an alpha of 1 every hit counts, of 0 none") {
  const std::vector<Shape> shapes{soup(200, 0.6f, 11), random_spheres(20, 0.4f, 12), soup(50, 0.5f, 13)};
  const auto opaque = build_accelerator(Backend::bvh, share(shapes));
  const auto full = build_accelerator(
      Backend::bvh, share_cut_out(shapes, {constant_alpha(1), constant_alpha(1), constant_alpha(2)}));
  const auto without = build_accelerator(Backend::bvh, share({Mesh{}, SphereSet{}, shapes[2]}));
  const auto empty =
      build_accelerator(Backend::bvh, share_cut_out(shapes, {constant_alpha(0), constant_alpha(-1)}));
  int hits = 0, fewer = 0;
  for (const Ray& ray : random_rays(3000, opaque->bounds(), 14)) {
    const Hit hit = opaque->closest_hit(ray), left = without->closest_hit(ray);
    REQUIRE(full->closest_hit(ray) == hit);
    REQUIRE(full->any_hit(ray) == bool(hit));
    REQUIRE(empty->closest_hit(ray) == left);
    REQUIRE(empty->any_hit(ray) == bool(left));
    hits += bool(hit);
    fewer += bool(left);
  }
  CHECK(hits > 1000);
  CHECK(fewer > 100);
  CHECK(fewer < hits - 500);
}

TEST_CASE("of an alpha between 0 and 1 this part of the hits counts, each by itself") {
  constexpr int count = 20000;
  check_part(hits_from_above(*share_cut_out({square(0)}, {constant_alpha(0.3f)}), count), count, 0.3);
  const std::vector<Texture> two{constant_alpha(0.5f), constant_alpha(0.5f)};
  check_part(hits_from_above(*share_cut_out({square(0), square(1)}, two), count), count, 0.75);
  // Both sides of a sphere, from within the square that it fills.
  const auto ball = share_cut_out({SphereSet{"ball", {{{0, 0, 0}, 2}}}}, {constant_alpha(0.5f)});
  check_part(hits_from_above(*ball, count), count, 0.75);
}

TEST_CASE("a checkerboard of alpha lets rays through its dark squares alone") {
  Mesh mesh = square(0);
  mesh.uvs = {{0, 0}, {8, 0}, {8, 8}, {0, 8}};
  mesh.uv_indices = mesh.triangles;
  const std::vector<Texture> textures{
      constant_alpha(1), constant_alpha(0), {"board", CheckerboardTexture{0, 1}}};
  std::vector<ShapeBinding> bindings(1);
  bindings[0].alpha = 2;
  const auto engine =
      build_accelerator(Backend::bvh, std::make_shared<const Geometry>(cut_out({mesh}, bindings, textures)));
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j) {
      const float x = (float(i) + 0.4f) / 4 - 1, y = (float(j) + 0.7f) / 4 - 1;
      CHECK(engine->any_hit({.origin = {x, y, 1}, .direction = {0, 0, -1}}) == ((i + j) % 2 == 0));
    }
}

TEST_CASE("holes may go by the points of the scene, also those of instances") {
  // A checkerboard of cubes, of which the square is a slice. One instance lies as the square does, one is
  // moved by a side to the right: its holes are those of the points where it is.
  const std::vector<Texture> textures{constant_alpha(1), constant_alpha(0), {"cubes", CubesTexture{0, 1}}};
  std::vector<ShapeBinding> bindings(1);
  bindings[0].alpha = 2;
  const std::vector<Instance> instances{{0, {}}, {0, Transform::translation(3, 0, 0)}};
  for (const Backend backend : {Backend::bvh, Backend::brute_force}) {
    const auto engine = build_accelerator(
        backend, std::make_shared<const Geometry>(
                     cut_out({square(0.25f)}, bindings, textures, Instancing{{{0, 1}}, instances})));
    for (const float x : {-0.6f, 0.6f, 2.4f, 3.4f})
      for (const float y : {-0.3f, 0.7f}) {
        CAPTURE(x, y);
        const bool is_even = (int(std::floor(x)) + int(std::floor(y))) % 2 == 0;
        CHECK(engine->any_hit({.origin = {x, y, 1}, .direction = {0, 0, -1}}) == is_even);
      }
  }
}

TEST_CASE("alpha is interpolated between the pixels of a picture that is filtered") {
  Image picture(2, 1);
  picture.at(1, 0) = {1, 1, 1};
  for (const TextureFilter filter :
       {TextureFilter::bilinear, TextureFilter::trilinear, TextureFilter::stochastic}) {
    ImageTexture image{.image = std::make_shared<const MipMap>(picture)};
    image.filter = filter;
    const std::vector<Texture> textures{{"ramp", image}};
    CHECK(alpha_at(textures, 0, {.uv = {0.5f, 0.5f}}) == Approx(0.5));
    CHECK(alpha_at(textures, 0, {.uv = {0.35f, 0.5f}}) == Approx(0.2));
  }
}

TEST_CASE("a shape with holes needs something that says which of its hits count") {
  Mesh mesh = square(0);
  mesh.name = "leaf";
  mesh.is_opaque = false;
  CHECK_THROWS_WITH(Geometry({mesh}),
                    "shape 0 \"leaf\": it is not opaque, but nothing says which of its hits count");
}
