// SPDX-License-Identifier: Apache-2.0
#include "io/picture/camera_matrices.h"

#include "tests/support/catch.h"
#include "tests/support/random.h"

namespace twinray::test {
namespace {

/// A point before a matrix, divided by what comes out last.
Vec3 transformed(const Vec3& p, const std::array<float, 16>& m) {
  const auto column = [&](std::size_t j) { return p.x * m[j] + p.y * m[4 + j] + p.z * m[8 + j] + m[12 + j]; };
  return Vec3{column(0), column(1), column(2)} / column(3);
}

Camera some_camera() {
  Camera camera;
  camera.position = {1, -2, 3};
  camera.forward = normalize({1, 2, -2});
  camera.right = normalize(cross(camera.forward, Vec3{0, 1, 0}));
  camera.up = cross(camera.right, camera.forward);
  return camera;
}

}  // namespace

TEST_CASE("a picture's matrices say where a point of the world lies in its frame") {
  constexpr float tolerance = 1e-4f;  // Of coordinates up to 50 in floats.
  Camera camera = some_camera();
  Random random(4);
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    camera.projection = projection;
    camera.frame_center = {0.2f, -0.3f};
    const CameraMatrices matrices = camera_matrices(camera);
    for (int trial = 0; trial < 100; ++trial) {
      const Vec2 frame{random.unit(), random.unit()};
      const Ray ray = camera_ray(camera, frame, {});
      const float depth = random.uniform(1, 30);
      const Vec3 point = ray.origin + ray.direction * depth;
      const Vec3 seen = transformed(point, *matrices.world_to_ndc);
      CHECK(seen.x == Approx(frame.x).margin(tolerance));
      CHECK(seen.y == Approx(frame.y).margin(tolerance));
      const Vec3 before = transformed(point, matrices.world_to_camera);
      CHECK(before.z == Approx(depth).epsilon(tolerance));
      CHECK(before.x == Approx(dot(point - camera.position, camera.right)).margin(tolerance));
      CHECK(before.y == Approx(dot(point - camera.position, camera.up)).margin(tolerance));
    }
  }
}

TEST_CASE("a panorama has the matrix of its camera, and none of its frame") {
  const Camera around = with_panorama(some_camera(), Projection::latitude_longitude, 0);
  const CameraMatrices matrices = camera_matrices(around);
  CHECK_FALSE(matrices.world_to_ndc);
  CHECK(matrices.world_to_camera == camera_matrices(some_camera()).world_to_camera);
}

}  // namespace twinray::test
