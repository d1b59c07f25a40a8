// SPDX-License-Identifier: Apache-2.0
// What makes the fast kernels fast: their own steps, counted in a counting build of the same source, are
// those of the scalar traversal, which takes the nearest child first and culls all that lies behind the hit
// so far.
#include "accel/wide/scalar.h"
#include "tests/support/catch.h"
#include "tests/support/shapes.h"
#include "tests/support/wide_engine.h"

using namespace twinray;
using namespace twinray::test;

namespace {

std::string text_of(const QueryCounts& counts) {
  return std::to_string(counts.nodes) + " nodes, " + std::to_string(counts.boxes) + " boxes, " +
         std::to_string(counts.leaves) + " leaves, " + std::to_string(counts.primitives) + " primitives";
}

/// A tree, rays, and the steps of the scalar traversal.
struct Expected {
  std::shared_ptr<const Geometry> geometry;
  WideBvh bvh = build_wide(*geometry);
  std::vector<Ray> rays;
  QueryCounts closest, any;

  Expected(std::shared_ptr<const Geometry> shapes, std::vector<Ray> asked)
      : geometry(std::move(shapes)), rays(std::move(asked)) {
    for (const Ray& ray : rays) {
      scalar_closest(bvh, *geometry, ray, closest);
      scalar_any(bvh, *geometry, ray, any);
    }
  }
};

/// Rays of which some end before what they would hit, and some are invalid.
std::vector<Ray> mixed_rays(const Geometry& geometry, std::uint64_t seed) {
  Random random(seed);
  std::vector<Ray> rays = random_rays(1000, geometry.bounds(), seed);
  for (Ray& ray : rays) {
    if (random.below(3) == 0) ray.t_max = random.unit();
    if (random.below(50) == 0) ray.direction = {};
    if (random.below(50) == 0) ray.direction = ray.direction * 0x1p-50f;
  }
  return rays;
}

std::vector<Expected> all_expected() {
  std::vector<Expected> all;
  for (const float size : {0.02f, 0.2f, 1.0f}) {
    const auto geometry = share({soup(3000, size, 1), random_spheres(40, size, 2)});
    all.emplace_back(geometry, mixed_rays(*geometry, 3));
  }
  const auto spheres = share({random_spheres(2000, 0.1f, 5)});
  all.emplace_back(spheres, mixed_rays(*spheres, 6));
  // Layers one behind the other, along each axis: where the order of children decides all.
  Mesh layers;
  for (int i = 0; i < 600; ++i) {
    const float d = float(i % 200);
    Vec3 corners[3] = {{d, -200, -200}, {d, 400, -200}, {d, -200, 400}};
    for (Vec3& p : corners) p = {p[i / 200], p[(i / 200 + 1) % 3], p[(i / 200 + 2) % 3]};
    add_triangle(layers, corners[0], corners[1], corners[2]);
  }
  const auto geometry = share({layers});
  all.emplace_back(geometry, mixed_rays(*geometry, 4));
  return all;
}

/// Steps and answers of a kernel's functions for many rays.
void check_many(decltype(CountingWideKernel::closest_batch) CountingWideKernel::*closest_of,
                decltype(CountingWideKernel::any_batch) CountingWideKernel::*any_of) {
  for (const Expected& expected : all_expected())
    for (const CountingWideKernel& kernel : counting_wide_kernels()) {
      CAPTURE(kernel.name);
      QueryCounts closest, any;
      std::vector<Hit> hits(expected.rays.size());
      std::vector<std::uint8_t> blocked(expected.rays.size());
      (kernel.*closest_of)(expected.bvh, *expected.geometry, expected.rays, hits.data(), closest);
      (kernel.*any_of)(expected.bvh, *expected.geometry, expected.rays, blocked.data(), any);
      CHECK(text_of(closest) == text_of(expected.closest));
      CHECK(text_of(any) == text_of(expected.any));
      for (std::size_t i = 0; i < hits.size(); ++i) {
        QueryCounts ignored;
        REQUIRE(hits[i] == kernel.closest(expected.bvh, *expected.geometry, expected.rays[i], ignored));
        REQUIRE(blocked[i] == kernel.any(expected.bvh, *expected.geometry, expected.rays[i], ignored));
      }
    }
}

}  // namespace

TEST_CASE("the fast kernels take the steps of the scalar traversal, one ray at a time") {
  for (const Expected& expected : all_expected())
    for (const CountingWideKernel& kernel : counting_wide_kernels()) {
      CAPTURE(kernel.name);
      QueryCounts closest, any;
      for (const Ray& ray : expected.rays) {
        kernel.closest(expected.bvh, *expected.geometry, ray, closest);
        kernel.any(expected.bvh, *expected.geometry, ray, any);
      }
      CHECK(text_of(closest) == text_of(expected.closest));
      CHECK(text_of(any) == text_of(expected.any));
    }
}

TEST_CASE("the fast kernels take the steps of the scalar traversal, one ray of many after the other") {
  check_many(&CountingWideKernel::closest_in_turn, &CountingWideKernel::any_in_turn);
}

TEST_CASE("the fast kernels take the steps of the scalar traversal in batches") {
  check_many(&CountingWideKernel::closest_batch, &CountingWideKernel::any_batch);
}

TEST_CASE("a counting kernel gives the bits of the timed one") {
  const Expected expected = std::move(all_expected()[1]);
  const std::vector<WideKernel> timed = wide_kernels();
  const std::vector<CountingWideKernel> counting = counting_wide_kernels();
  REQUIRE(counting.size() + 1 == timed.size());
  for (std::size_t i = 0; i < counting.size(); ++i) {
    CHECK(counting[i].name == timed[i].name);
    QueryCounts counts;
    for (const Ray& ray : expected.rays) {
      REQUIRE(counting[i].closest(expected.bvh, *expected.geometry, ray, counts) ==
              timed[i].closest(expected.bvh, *expected.geometry, ray));
      REQUIRE(counting[i].any(expected.bvh, *expected.geometry, ray, counts) ==
              timed[i].any(expected.bvh, *expected.geometry, ray));
    }
  }
}

TEST_CASE("the scalar traversal sees little of a scene of layers") {
  // 600 triangles, 200 across each axis, each as large as the scene: a ray's nearest hit hides most of them.
  const Expected layers = std::move(all_expected().back());
  const double rays = double(layers.rays.size());
  CHECK(double(layers.closest.leaves) / rays < 30);
  CHECK(double(layers.any.leaves) / rays < 20);
}
