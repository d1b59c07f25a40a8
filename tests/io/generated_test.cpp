// SPDX-License-Identifier: Apache-2.0
#include "io/generated/generated.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <string>

#include "accel/accelerator.h"
#include "core/error.h"
#include "core/random.h"
#include "integrators/path.h"
#include "integrators/render.h"
#include "io/scene_file.h"
#include "tests/support/catch.h"

using namespace twinray;
using namespace twinray::generated;

namespace {

constexpr std::size_t small = 50'000;
/// What generated.h promises.
constexpr double size_tolerance = 0.02;

/// A hash of every float of a scene's meshes and every index: FNV-1a over 32-bit words.
class Digest {
 public:
  explicit Digest(const Geometry& geometry) {
    for (const Shape& shape : geometry.shapes()) {
      const Mesh& mesh = std::get<Mesh>(shape);
      for (const Vec3& p : mesh.positions)
        for (int axis = 0; axis < 3; ++axis) add(std::bit_cast<std::uint32_t>(p[axis]));
      for (const Triangle& triangle : mesh.triangles)
        for (const std::uint32_t index : triangle) add(index);
    }
  }
  std::uint64_t value() const { return value_; }

 private:
  void add(std::uint32_t word) { value_ = (value_ ^ word) * 0x100000001b3u; }
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

std::size_t degenerate_triangles(const Geometry& geometry) {
  std::size_t count = 0;
  for (const Shape& shape : geometry.shapes()) {
    const Mesh& mesh = std::get<Mesh>(shape);
    for (const auto& [a, b, c] : mesh.triangles)
      count += !has_area(mesh.positions[a], mesh.positions[b], mesh.positions[c]);
  }
  return count;
}

RenderResult picture(const Scene& scene) {
  const auto accelerator = build_accelerator(Backend::bvh, scene.geometry);
  const PathIntegrator path(scene, {.max_depth = 5});
  return render(scene, *accelerator, path, {.width = 80, .height = 60, .samples = 4});
}

}  // namespace

TEST_CASE("a generated scene has the triangles it was asked for, all with an area") {
  for (const GeneratedScene& maker : generated_scenes())
    for (const std::size_t triangles : {small, std::size_t(300'000)}) {
      CAPTURE(maker.name, triangles);
      const Scene scene = maker.make(triangles);
      const double count = double(scene.geometry->triangle_count());
      CHECK(std::fabs(count / double(triangles) - 1) <= size_tolerance);
      CHECK(degenerate_triangles(*scene.geometry) == 0);
    }
}

TEST_CASE("a forest of 10,000 triangles and a ball of 1,000 can be made") {
  CHECK(make_forest(10'000).geometry->triangle_count() == 10'000);
  CHECK(make_ball(1'000).geometry->triangle_count() > 980);
}

TEST_CASE("a size that a generated scene cannot have is refused by name") {
  CHECK_THROWS_WITH(make_room(100), "the scene room of 100 triangles: it can have 50000 to 268435456");
  CHECK_THROWS_AS(make_forest(std::size_t(1) << 29), Error);
  CHECK_THROWS_AS(make_ball(10), Error);
}

TEST_CASE("generated scenes have the same bits on every machine") {
  const std::uint64_t expected[] = {0x3b7ff1bb78b9f517u, 0x4bcdede115d9aeacu, 0x494d4344f89e4d6du};
  for (std::size_t i = 0; i < generated_scenes().size(); ++i) {
    CAPTURE(generated_scenes()[i].name);
    CHECK(Digest(*generated_scenes()[i].make(small).geometry).value() == expected[i]);
  }
}

TEST_CASE("paths through generated scenes bounce, and the pictures are neither black nor white") {
  for (const GeneratedScene& maker : generated_scenes()) {
    CAPTURE(maker.name);
    const RenderResult result = picture(maker.make(small));
    CHECK(result.rays.bounce > 3 * result.rays.camera / 4);
    CHECK(result.film.rejected_count() == 0);
    double sum = 0;
    for (int y = 0; y < 60; ++y)
      for (int x = 0; x < 80; ++x) sum += std::min(1.0, result.film.pixel(x, y).luminance_mean());
    CHECK(sum / (80 * 60) > 0.1);
    CHECK(sum / (80 * 60) < 0.8);
  }
}

TEST_CASE("no ray from inside leaves the room or the ball's box") {
  constexpr int rays = 20'000;
  for (const auto& [scene, center] :
       {std::pair{make_room(small), Vec3{-0.5f, 1.5f, 1.2f}}, {make_ball(small), Vec3{1.5f, 1.2f, 2.2f}}}) {
    const auto accelerator = build_accelerator(Backend::bvh, scene.geometry);
    Random random(3);
    int escaped = 0;
    for (int i = 0; i < rays; ++i)
      escaped += !accelerator->any_hit({.origin = center, .direction = random.in_ball()});
    CHECK(escaped == 0);
  }
}

TEST_CASE("load_scene takes the names of generated scenes, with a number of triangles if wanted") {
  const LoadedScene loaded = load_scene("generated:ball:2000");
  CHECK(loaded.scene.geometry->triangle_count() == make_ball(2000).geometry->triangle_count());
  CHECK(loaded.summary.triangles == loaded.scene.geometry->triangle_count());
  CHECK(loaded.summary.camera == "generated:ball:2000");
  CHECK(loaded.warnings.empty());
  CHECK(make_generated("generated:room:50000").geometry->triangle_count() ==
        make_room(50000).geometry->triangle_count());
}

TEST_CASE("generated scenes of instances have about as many as are asked for, all of their prototypes") {
  for (const GeneratedScene& maker : instanced_scenes()) {
    CAPTURE(maker.name);
    const Scene scene = maker.make(2000);
    const Geometry& geometry = *scene.geometry;
    CHECK(geometry.instances().size() >= 2000);
    CHECK(geometry.instances().size() <= 2100);
    CHECK(geometry.seen_primitives() > 100 * 2000);
    CHECK(geometry.primitive_count() < 200'000);
    std::vector<int> shown(geometry.prototypes().size());
    int mirrored = 0;
    for (const Instance& instance : geometry.instances()) {
      ++shown[instance.prototype];
      mirrored += instance.to_world.determinant() < 0;
    }
    for (const int times : shown) CHECK(times > 0);
    CHECK(mirrored == Approx(1000).margin(60));
    CHECK_THROWS_WITH(maker.make(0), Catch::Contains("of 0 instances: it can have 1 to 268435456"));
  }
  CHECK(load_scene("generated:woods:20").summary.instances == 20);
  CHECK_THROWS_WITH(load_scene("generated:woods:x"),
                    "generated:woods:x: \"x\" is not a number of instances, such as 10000");
}

TEST_CASE("a wrong name of a generated scene is refused with the valid ones") {
  CHECK_THROWS_WITH(
      load_scene("generated:bal"),
      "generated:bal: there is no such scene; valid are generated:room, generated:ball, "
      "generated:forest, generated:woods, generated:stadium, each with :N behind it for N triangles "
      "or, of the last two, instances");
  for (const char* size : {"", "1e6", "-5", "99999999999999999999999"})
    CHECK_THROWS_WITH(
        load_scene(fmt::format("generated:ball:{}", size)),
        fmt::format("generated:ball:{0}: \"{0}\" is not a number of triangles, such as 900000", size));
  CHECK_THROWS_WITH(load_scene("generated:room:100"),
                    "the scene room of 100 triangles: it can have 50000 to 268435456");
}
