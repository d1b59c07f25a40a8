// SPDX-License-Identifier: Apache-2.0
#include "core/camera.h"

#include <cmath>

#include "tests/support/catch.h"

namespace twinray {
namespace {

/// Directions are products of a few floats.
constexpr double rounding = 1e-6;

Camera tilted() {
  Camera camera;
  camera.position = {1, 2, 3};
  camera.forward = {0, -0.6f, -0.8f};
  camera.right = {1, 0, 0};
  camera.up = {0, 0.8f, -0.6f};
  camera.tan_half_width = 0.6f;
  camera.tan_half_height = 0.3f;
  return camera;
}

/// Whether the frame holds a point.
bool sees(const Camera& camera, const Vec3& point) {
  const Vec3 p = point - camera.position;
  const float depth = dot(p, camera.forward);
  return depth >= camera.clip_near && depth <= camera.clip_far &&
         std::fabs(dot(p, camera.right)) <= camera.tan_half_width * depth &&
         std::fabs(dot(p, camera.up)) <= camera.tan_half_height * depth;
}

/// How many corners of a box the frame holds.
int corners_seen(const Camera& camera, const Aabb& box) {
  int seen = 0;
  for (const float x : {box.lower.x, box.upper.x})
    for (const float y : {box.lower.y, box.upper.y})
      for (const float z : {box.lower.z, box.upper.z}) seen += sees(camera, {x, y, z});
  return seen;
}

}  // namespace

TEST_CASE("the frame's corners are the field of view's, the top left first") {
  const Camera camera = tilted();
  const Ray ray = camera_ray(camera, {0, 0}, {});
  CHECK(ray.origin == camera.position);
  CHECK(dot(ray.direction, camera.forward) == Approx(1).epsilon(rounding));
  CHECK(dot(ray.direction, camera.right) == Approx(-0.6).epsilon(rounding));
  CHECK(dot(ray.direction, camera.up) == Approx(0.3).epsilon(rounding));
  CHECK(camera_ray(camera, {0.5f, 0.5f}, {}).direction == camera.forward);
}

TEST_CASE("t counts depth, so clipping is by planes across the view") {
  Camera camera = tilted();
  camera.clip_near = 2;
  camera.clip_far = 9;
  const Ray ray = camera_ray(camera, {0.1f, 0.9f}, {});
  CHECK(ray.t_min == 2);
  CHECK(ray.t_max == 9);
  CHECK(dot(ray.direction * 7, camera.forward) == Approx(7).epsilon(rounding));
}

TEST_CASE("clip distances may count along each ray") {
  Camera camera = tilted();
  camera.clips_by_distance = true;
  camera.clip_near = 2;
  camera.clip_far = 9;
  for (const float lens_radius : {0.0f, 0.25f}) {
    camera.lens_radius = lens_radius;
    const Ray ray = camera_ray(camera, {0.1f, 0.9f}, {0.5f, -0.5f});
    CHECK(length(ray.direction) > 1.05f);
    CHECK(length(ray.direction * ray.t_min) == Approx(2).epsilon(rounding));
    CHECK(length(ray.direction * ray.t_max) == Approx(9).epsilon(rounding));
  }
}

TEST_CASE("a lens is clipped as a pinhole is") {
  Camera camera = tilted();
  camera.lens_radius = 0.25f;
  camera.clip_near = 2;
  camera.clip_far = 9;
  const Ray ray = camera_ray(camera, {0.1f, 0.9f}, {0.5f, -0.5f});
  CHECK(ray.t_min == 2);
  CHECK(ray.t_max == 9);
}

TEST_CASE("a lens blurs all but the plane in focus") {
  Camera camera = tilted();
  camera.lens_radius = 0.25f;
  camera.focal_distance = 5;
  const Ray center = camera_ray(camera, {0.3f, 0.6f}, {0, 0}),
            edge = camera_ray(camera, {0.3f, 0.6f}, {1, 0});
  CHECK(length(edge.origin - center.origin) == Approx(0.25));
  const Vec3 a = center.origin + center.direction * 5, b = edge.origin + edge.direction * 5;
  CHECK(length(a - b) <= 1e-5f);
  for (const Ray& ray : {center, edge}) CHECK(dot(ray.direction, camera.forward) == Approx(1));
  CHECK(length((center.origin + center.direction * 9) - (edge.origin + edge.direction * 9)) > 0.1f);
}

TEST_CASE("a picture of another shape shows more on one side and never less of the frame") {
  const Camera camera = tilted();  // 2 : 1
  const Camera wider = fit_frame(camera, 400, 100), narrower = fit_frame(camera, 100, 100);
  CHECK(wider.tan_half_height == camera.tan_half_height);
  CHECK(wider.tan_half_width == Approx(1.2));
  CHECK(narrower.tan_half_width == camera.tan_half_width);
  CHECK(narrower.tan_half_height == Approx(0.6));
  const Camera same = fit_frame(camera, 200, 100);
  CHECK(same.tan_half_width == Approx(0.6));
  CHECK(same.tan_half_height == Approx(0.3));
}

TEST_CASE("a stretched frame stays as it is whatever the picture's shape") {
  Camera camera = tilted();
  camera.is_stretched = true;
  const Camera fitted = fit_frame(camera, 100, 400);
  CHECK(fitted.tan_half_width == camera.tan_half_width);
  CHECK(fitted.tan_half_height == camera.tan_half_height);
}

TEST_CASE("the view of the whole keeps the direction and has the box just within its frame") {
  const Aabb box{{-3, -1, 2}, {5, 4, 8}};
  const Camera moved = view_whole(tilted(), box);
  CHECK(moved.forward == tilted().forward);
  CHECK(corners_seen(moved, box) == 8);
  Camera closer = moved;
  closer.position += moved.forward * (0.1f * length(box.extent()));
  CHECK(corners_seen(closer, box) < 8);
  CHECK(view_whole(tilted(), {}).position == tilted().position);
}

TEST_CASE("an orthographic camera's rays are parallel, and its frame is in scene units") {
  Camera camera = tilted();
  camera.is_orthographic = true;
  camera.clip_far = 9;
  const Ray corner = camera_ray(camera, {0, 0}, {}), middle = camera_ray(camera, {0.5f, 0.5f}, {});
  CHECK(corner.direction == camera.forward);
  CHECK(middle.direction == camera.forward);
  CHECK(middle.origin == camera.position);
  CHECK(dot(corner.origin - camera.position, camera.right) == Approx(-0.6).epsilon(rounding));
  CHECK(dot(corner.origin - camera.position, camera.up) == Approx(0.3).epsilon(rounding));
  CHECK(std::fabs(dot(corner.origin - camera.position, camera.forward)) < rounding);
  CHECK(corner.t_max == 9);
}

TEST_CASE("an orthographic camera is moved to where it sees a whole box, with a frame that just holds it") {
  Camera camera = tilted();
  camera.is_orthographic = true;
  camera.clip_near = 2;
  const Aabb box{{10, 20, 30}, {14, 21, 33}};
  const Camera moved = view_whole(camera, box);
  float largest = 0;
  for (const float x : {10.0f, 14.0f})
    for (const float y : {20.0f, 21.0f})
      for (const float z : {30.0f, 33.0f}) {
        const Vec3 p = Vec3{x, y, z} - moved.position;
        CHECK(dot(p, moved.forward) > 0);
        largest = std::max({largest, std::fabs(dot(p, moved.right)) / moved.tan_half_width,
                            std::fabs(dot(p, moved.up)) / moved.tan_half_height});
      }
  CHECK(largest == Approx(1 / 1.04));
  CHECK(moved.tan_half_width / moved.tan_half_height == Approx(2));
  CHECK(moved.clip_near == 0);
  CHECK(moved.forward == camera.forward);
}

}  // namespace twinray
