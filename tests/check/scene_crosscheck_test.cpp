// SPDX-License-Identifier: Apache-2.0
#include "check/scene_crosscheck.h"

#include "check/ceilings.h"
#include "check/recorded_rays.h"
#include "core/error.h"
#include "tests/support/catch.h"
#include "tests/support/cut_outs.h"
#include "tests/support/hard_meshes.h"
#include "tests/support/scenes.h"

namespace twinray::test {
namespace {

CrosscheckOptions options(std::uint64_t rays, int threads) {
  return {.engines = engine_names(), .rays = rays, .threads = threads};
}

/// A grey mesh between a floor and a light above; the camera looks at the origin of coordinates.
Scene lit(Mesh mesh) {
  Aabb bounds;
  for (const Vec3& p : mesh.positions) bounds.extend(p);
  const Vec3 center = bounds.center();
  const float half = 0.5f * max_abs(bounds.extent());
  const auto at = [&](float x, float y, float z) { return center + Vec3{x, y, z} * half; };
  add_triangle(mesh, at(-3, -1.2f, -3), at(-3, -1.2f, 3), at(3, -1.2f, -3));
  add_triangle(mesh, at(3, -1.2f, -3), at(-3, -1.2f, 3), at(3, -1.2f, 3));
  Scene scene = scene_of(std::move(mesh), {0.7f, 0.7f, 0.7f}, {2, 1.5f, 3}, {0, 0, 0});
  Mesh lamp = floor_square(half, 0);
  for (Vec3& p : lamp.positions) p = center + Vec3{p.x, 1.5f * half, -p.z};
  add_lamp(scene, std::move(lamp), {5, 5, 5}, EmissionSide::front);
  return scene;
}

}  // namespace

TEST_CASE("all classes of rays are shot through all engines, and nothing is unexplained") {
  const SceneCrosscheck result = crosscheck_scene(small_room(), options(40000, 0));
  CHECK(result.report.unexplained() == 0);
  CHECK(passed_ceilings(result.report).empty());
  REQUIRE(result.engines.size() == engine_names().size());
  for (std::size_t engine = 0; engine < result.engines.size(); ++engine) {
    std::uint64_t rays = 0;
    for (std::size_t i = 0; i < ray_class_count; ++i) {
      const Tally& tally = result.report.tally(engine, RayClass(i));
      INFO(result.engines[engine] << " " << ray_class_name(RayClass(i)));
      CHECK(tally.rays > 0);
      rays += tally.rays;
    }
    CHECK(rays == (result.engines[engine] == "brute-force" ? 10000 : 40000));
  }
}

TEST_CASE("nothing is unexplained on any class of rays, light paths included, on hard meshes") {
  for (const Mesh& mesh : hard_meshes()) {
    INFO(mesh.name << " of " << mesh.triangles.size() << " triangles");
    const SceneCrosscheck result = crosscheck_scene(lit(mesh), options(20000, 0));
    CHECK(result.report.unexplained() == 0);
    for (std::size_t engine = 0; engine < result.engines.size(); ++engine)
      for (std::size_t i = 0; i < ray_class_count; ++i) {
        INFO(result.engines[engine] << " " << ray_class_name(RayClass(i)));
        const Tally& tally = result.report.tally(engine, RayClass(i));
        CHECK(tally.rays > 0);
        if (result.engines[engine] != "embree-native")
          CHECK(tally.count(Difference::identical) == tally.rays);
      }
  }
}

TEST_CASE("nothing is unexplained where shapes have holes, and Embree's own triangles have the same ones") {
  Scene scene = small_room();
  set_alpha(scene, 0, constant_alpha(0.9f));  // The walls: rays leave the room.
  for (std::uint32_t shape = 1; shape < scene.bindings.size(); ++shape)
    set_alpha(scene, shape, random_alpha(shape));
  const SceneCrosscheck result = crosscheck_scene(scene, options(40000, 0));
  CHECK(result.report.unexplained() == 0);
  for (std::size_t engine = 0; engine < result.engines.size(); ++engine) {
    INFO(result.engines[engine]);
    Tally all;
    for (std::size_t i = 0; i < ray_class_count; ++i) all += result.report.tally(engine, RayClass(i));
    if (result.engines[engine] != "embree-native")
      CHECK(all.count(Difference::identical) == all.rays);
    else
      CHECK(all.count(Difference::cut_out) < all.rays / 100);
  }
}

TEST_CASE("a crosscheck takes both widths of the bvh and Embree, or brute force, unless told otherwise") {
#ifdef TWINRAY_WITH_EMBREE
  CHECK(default_crosscheck_engines() == std::vector<std::string>{"bvh", "embree", "bvh-2", "embree-native"});
#else
  CHECK(default_crosscheck_engines() == std::vector<std::string>{"bvh", "bvh-2", "brute-force"});
#endif
  CHECK(named_engine("bvh").build.bvh_width == 8);
  CHECK(named_engine("bvh-2").build.bvh_width == 2);
}

TEST_CASE("a crosscheck does not depend on the number of threads") {
  const Scene scene = small_room();
  const SceneCrosscheck one = crosscheck_scene(scene, options(30000, 1));
  const SceneCrosscheck three = crosscheck_scene(scene, options(30000, 3));
  for (std::size_t engine = 0; engine < one.engines.size(); ++engine)
    for (std::size_t i = 0; i < ray_class_count; ++i) {
      CHECK(one.report.tally(engine, RayClass(i)) == three.report.tally(engine, RayClass(i)));
      const auto &a = one.report.findings(engine, RayClass(i)),
                 &b = three.report.findings(engine, RayClass(i));
      REQUIRE(a.size() == b.size());
      for (std::size_t k = 0; k < a.size(); ++k) CHECK(a[k].number == b[k].number);
    }
}

TEST_CASE("another seed gives other rays") {
  const Scene scene = small_room();
  const auto accelerator = build_accelerator(Backend::bvh, scene.geometry);
  const auto a = PathRays(scene, *accelerator, 0).batch(3, 100);
  const auto b = PathRays(scene, *accelerator, 1).batch(3, 100);
  const auto again = PathRays(scene, *accelerator, 0).batch(3, 100);
  int equal = 0;
  for (int i = 0; i < 100; ++i) {
    CHECK(a[i].ray.direction == again[i].ray.direction);
    equal += a[i].ray.direction == b[i].ray.direction;
  }
  CHECK(equal == 0);
}

TEST_CASE("one ray is told with every engine's answer and the truth") {
  const Scene scene = small_room();
  const Ray ray{.origin = {0, 0, 0}, .direction = {0, 0.1f, -1}};
  const RayCrosscheck result = crosscheck_ray(scene, ray, Placement::file, options(1, 1));
  CHECK(result.rows.size() == engine_names().size());
  REQUIRE_FALSE(result.truth.empty());
  for (const RayCrosscheck::Row& row : result.rows) {
    CHECK(row.difference <= Difference::rounding);
    CHECK(row.answer.closest.t == Approx(result.truth[0].t.value));
    CHECK(row.answer.closest.primitive == result.truth[0].primitive);
  }
}

TEST_CASE("a crosscheck without a fast canonical engine, or without rays, is refused") {
  const Scene scene = small_room();
  CHECK_THROWS_WITH(crosscheck_scene(scene, {.engines = {"bvh"}}),
                    "a crosscheck needs two engines, one of them bvh, bvh-2 or embree");
  CHECK_THROWS_WITH(crosscheck_scene(scene, {.engines = {"brute-force", "brute-force"}}),
                    "a crosscheck needs two engines, one of them bvh, bvh-2 or embree");
  CHECK_THROWS_WITH(crosscheck_scene(scene, options(0, 0)), "the number of rays must lie in [1, 10^12]");
}

TEST_CASE("ceilings allow a ten-thousandth of the common rays and no leak through an edge") {
  CHECK(ceiling_of(RayClass::camera, 100000)->most == 10);
  CHECK(ceiling_of(RayClass::bounce, 1)->most == 1);
  CHECK(ceiling_of(RayClass::edges, 100000)->most == 0);
  CHECK(ceiling_of(RayClass::vertices, 1000)->most == 5);
  CHECK_FALSE(ceiling_of(RayClass::grazing, 1000));
  CrosscheckReport report(2);
  Finding leak{.ray_class = RayClass::edges, .engine = 1, .difference = Difference::edge, .is_leak = true};
  report.add(leak, true);
  REQUIRE(passed_ceilings(report).size() == 1);
  CHECK(passed_ceilings(report)[0].engine == 1);
  CHECK(passed_ceilings(report)[0].found == 1);
}

}  // namespace twinray::test
