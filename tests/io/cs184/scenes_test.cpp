// SPDX-License-Identifier: Apache-2.0
// CS184's own files, as the user's folder of scenes has them.
#include "io/scene_file.h"
#include "tests/support/catch.h"
#include "tests/support/cs184/compare.h"

namespace twinray {
namespace {

struct Expected {
  std::string file;
  std::size_t triangles, spheres, lights, warnings;
};

const Expected scenes[] = {{"keenan/banana.dae", 2458, 0, 2, 0},
                           {"meshedit/cow.dae", 5856, 0, 1, 0},
                           {"meshedit/maxplanck.dae", 50801, 0, 1, 0},
                           {"meshedit/teapot.dae", 2464, 0, 1, 0},
                           {"simple/cube.dae", 12, 0, 1, 0},
                           {"simple/plane.dae", 2, 0, 1, 0},
                           {"sky/bunny.dae", 33696, 0, 1, 0},
                           {"sky/CBbunny.dae", 28588, 0, 1, 0},
                           {"sky/CBcoil.dae", 7884, 0, 1, 0},
                           {"sky/CBdragon.dae", 100012, 0, 1, 0},
                           {"sky/CBempty.dae", 12, 0, 1, 0},
                           {"sky/CBgems.dae", 252, 0, 1, 2},
                           {"sky/CBlucy.dae", 99982, 0, 1, 0},
                           {"sky/CBspheres.dae", 12, 2, 1, 0},
                           {"sky/CBspheres_lambertian.dae", 12, 2, 1, 0},
                           {"sky/CBspheres_microfacet_al_ag.dae", 12, 2, 1, 0}};

LoadedScene load(const std::string& file, const LoadOptions& options = {}) {
  return load_scene(std::string(TWINRAY_SCENES) + "/cs184/" + file, options);
}

}  // namespace

TEST_CASE("each of CS184's files loads with its triangles, spheres and lights") {
  for (const Expected& expected : scenes) {
    INFO(expected.file);
    const LoadedScene loaded = load(expected.file);
    CHECK(loaded.scene.geometry->triangle_count() == expected.triangles);
    CHECK(loaded.scene.geometry->sphere_count() == expected.spheres);
    CHECK(loaded.scene.lights.size() == expected.lights);
    CHECK(loaded.warnings.size() == expected.warnings);
    CHECK(loaded.summary.dropped_triangles == 0);
  }
}

TEST_CASE("the lamp of CBbunny is its mesh, one-sided, and shines down") {
  const LoadedScene loaded = load("sky/CBbunny.dae");
  const auto& lamp = std::get<MeshLight>(loaded.scene.lights.at(0).source);
  CHECK(lamp.radiance == Rgb{10, 10, 10});
  const Mesh& mesh = *loaded.scene.geometry->mesh(lamp.shape);
  const Vec3& a = mesh.positions[mesh.triangles[0][0]];
  const Vec3 front =
      cross(mesh.positions[mesh.triangles[0][1]] - a, mesh.positions[mesh.triangles[0][2]] - a);
  CHECK((lamp.side == EmissionSide::front ? front.y : -front.y) < 0);
  CHECK(lamp.side != EmissionSide::both);
}

TEST_CASE("kept apart, the rectangle and the mesh of CBbunny are two lights") {
  const LoadedScene loaded = load("sky/CBbunny.dae", {.keep_both_lamps = true});
  CHECK(loaded.scene.lights.size() == 2);
  CHECK(loaded.scene.geometry->triangle_count() == 28590);
}

TEST_CASE("the camera of CBgems, whose matrix lacks a number, is that of CBcoil") {
  const Camera gems = load("sky/CBgems.dae").scene.camera, coil = load("sky/CBcoil.dae").scene.camera;
  CHECK(gems.position == coil.position);
  CHECK(gems.forward == coil.forward);
  CHECK(gems.up == coil.up);
  CHECK(gems.right == coil.right);
  CHECK(gems.tan_half_width == coil.tan_half_width);
}

TEST_CASE("strict mode takes all of CS184's files but CBgems") {
  for (const Expected& expected : scenes) {
    INFO(expected.file);
    if (expected.warnings == 0)
      CHECK_NOTHROW(load(expected.file, {.strict = true}));
    else
      CHECK_THROWS_AS(load(expected.file, {.strict = true}), Error);
  }
}

TEST_CASE("normals of CS184's files are those of its program") {
  constexpr double most_beyond_one_step = 0.002, most_outline = 0.0005;
  for (const Expected& expected : scenes)
    for (const auto& [width, height] : {std::pair{480, 360}, {60, 45}}) {
      CAPTURE(expected.file, width, height);
      const test::cs184::Difference difference = test::cs184::difference_of_file(
          std::string(TWINRAY_SCENES) + "/cs184/" + expected.file, width, height);
      CHECK(difference.beyond_one_step <= most_beyond_one_step);
      CHECK(difference.outline <= most_outline);
    }
}

}  // namespace twinray
