// SPDX-License-Identifier: Apache-2.0
#include "core/camera.h"

#include "core/direction_map.h"

#include <cmath>

#include "tests/support/catch.h"
#include "tests/support/lens.h"

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

TEST_CASE("rays of a lens system count depths as others do, or distances") {
  Camera camera = tilted();
  camera.lenses = test::camera_with_lens_system().lenses;
  camera.clip_near = 2;
  camera.clip_far = 9;
  const LensRay deep = lens_ray(camera, {0.4f, 0.6f}, {0.5f, 0.5f});
  CHECK(deep.light > 0);
  CHECK(dot(deep.ray.direction, camera.forward) == Approx(1).epsilon(rounding));
  CHECK(deep.ray.t_min == 2);
  CHECK(deep.ray.t_max == 9);
  camera.clips_by_distance = true;
  CHECK(length(lens_ray(camera, {0.4f, 0.6f}, {0.5f, 0.5f}).ray.direction) == Approx(1).epsilon(rounding));
}

TEST_CASE("a ray that a lens system stops is that of a pinhole, without light") {
  Camera camera = tilted();
  camera.lenses = test::camera_with_lens_system().lenses;
  const Vec2 corner_of_pupil{0, 0};
  const LensRay stopped = lens_ray(camera, {0.4f, 0.6f}, corner_of_pupil);
  CHECK(stopped.light == 0);
  CHECK(stopped.ray.direction == camera_ray(camera, {0.4f, 0.6f}, {}).direction);
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
  camera.projection = Projection::orthographic;
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
  camera.projection = Projection::orthographic;
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

TEST_CASE("a shifted frame shows what lies beside the axis of view, without a turn") {
  Camera camera = tilted();
  camera.frame_center = {0.3f, -0.6f};
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    camera.projection = projection;
    const Ray corner = camera_ray(camera, {0, 0}, {}), middle = camera_ray(camera, {0.5f, 0.5f}, {});
    const auto at_1 = [&](const Ray& ray) { return ray.origin + ray.direction - camera.position; };
    CHECK(dot(at_1(middle), camera.right) == Approx(0.3).epsilon(rounding));
    CHECK(dot(at_1(middle), camera.up) == Approx(-0.6).epsilon(rounding));
    CHECK(dot(at_1(corner), camera.right) == Approx(-0.3).epsilon(rounding));
    CHECK(dot(at_1(corner), camera.up) == Approx(-0.3).epsilon(rounding));
    CHECK(dot(corner.direction, camera.forward) == Approx(1).epsilon(rounding));
  }
}

namespace {

/// The direction of a point of the frame along the camera's axes: right, up, forward.
Vec3 seen(const Camera& camera, Vec2 frame) {
  const Vec3 d = camera_ray(camera, frame, {}).direction;
  return {dot(d, camera.right), dot(d, camera.up), dot(d, camera.forward)};
}

bool near(const Vec3& a, const Vec3& b) { return length(a - b) < 1e-5f; }

/// Of the frame's unit directions: the solid angle around a point, over the share of the frame.
double solid_angle_density(const Camera& camera, Vec2 at) {
  constexpr float step = 1.0f / 1024;
  const Vec3 across = seen(camera, {at.x + step, at.y}) - seen(camera, {at.x - step, at.y});
  const Vec3 along = seen(camera, {at.x, at.y + step}) - seen(camera, {at.x, at.y - step});
  return double(length(cross(across, along))) / (4 * double(step) * step);
}

}  // namespace

TEST_CASE("a latitude-longitude picture has the way ahead in its middle, and the poles at its edges") {
  const Camera camera = with_panorama(tilted(), Projection::latitude_longitude, 0);
  CHECK(near(seen(camera, {0.5f, 0.5f}), {0, 0, 1}));
  CHECK(near(seen(camera, {0.75f, 0.5f}), {1, 0, 0}));
  CHECK(near(seen(camera, {0.25f, 0.5f}), {-1, 0, 0}));
  CHECK(near(seen(camera, {0, 0.5f}), {0, 0, -1}));
  CHECK(near(seen(camera, {0.3f, 0}), {0, 1, 0}));
  CHECK(near(seen(camera, {0.9f, 1}), {0, -1, 0}));
  const float half = std::sqrt(0.5f);
  CHECK(near(seen(camera, {0.625f, 0.25f}), {0.5f, half, 0.5f}));
  // Beside the frame it goes on around, and over a pole down on the other side.
  CHECK(near(seen(camera, {1.25f, 0.5f}), {-1, 0, 0}));
  CHECK(near(seen(camera, {0.5f, -0.25f}), {0, half, -half}));
  CHECK(camera_ray(camera, {0.1f, 0.2f}, {}).origin == camera.position);
}

TEST_CASE("an equidistant fisheye's angle to the axis grows as the distance from the middle") {
  const Camera camera = fit_frame(with_panorama(tilted(), Projection::fisheye, 1.5f), 200, 100);
  for (const float angle : {0.0f, 0.3f, 1.1f, 1.49f}) {
    CAPTURE(angle);
    // 3 radians are half of the width, and 1.5 half of the height.
    CHECK(near(seen(camera, {0.5f + angle / 6, 0.5f}), {std::sin(angle), 0, std::cos(angle)}));
    CHECK(near(seen(camera, {0.5f, 0.5f - angle / 3}), {0, std::sin(angle), std::cos(angle)}));
    const float leg = angle * std::sqrt(0.5f);
    const Ray slanted = camera_ray(camera, {0.5f - leg / 6, 0.5f + leg / 3}, {});
    CHECK(dot(slanted.direction, camera.forward) == Approx(std::cos(angle)).margin(1e-6));
    CHECK(slanted.t_max > slanted.t_min);
  }
  const Ray beside = camera_ray(camera, {0.5f + 1.51f / 6, 0.5f}, {});
  CHECK(beside.t_max < beside.t_min);
  CHECK(length(beside.direction) == Approx(1));
}

TEST_CASE("an equal-area picture gives each pixel the same solid angle, and goes on over its edges") {
  const Camera camera = with_panorama(tilted(), Projection::equal_area, 0);
  for (const Vec2 at : {Vec2{0.3f, 0.2f}, {0.6f, 0.7f}, {0.1f, 0.45f}, {0.9f, 0.8f}, {0.05f, 0.06f}})
    CHECK(solid_angle_density(camera, at) == Approx(4 * M_PI).epsilon(0.01));
  CHECK(near(seen(camera, {0.5f, 0.5f}), {0, 1, 0}));
  CHECK(near(seen(camera, {1, 0.5f}), {1, 0, 0}));
  CHECK(near(seen(camera, {0.5f, 1}), {0, 0, 1}));
  for (const Vec2 corner : {Vec2{0, 0}, {1, 0}, {0, 1}, {1, 1}})
    CHECK(near(seen(camera, corner), {0, -1, 0}));
  CHECK(near(seen(camera, {-0.1f, 0.2f}), seen(camera, {0.1f, 0.8f})));
  CHECK(near(seen(camera, {0.3f, 1.2f}), seen(camera, {0.7f, 0.8f})));
}

TEST_CASE("an equal-area picture is an environment's, with the way ahead along -z") {
  const Camera camera = with_panorama({}, Projection::equal_area, 0);
  for (const Vec2 at : {Vec2{0.3f, 0.2f}, {0.6f, 0.7f}, {0.1f, 0.45f}, {0.9f, 0.8f}}) {
    const Vec3 d = camera_ray(camera, at, {}).direction;
    const MapPoint point = map_point(MapLayout::equal_area, {d.x, -d.z, d.y});  // The map lies around its z.
    CHECK(point.x == Approx(at.x).margin(1e-6));
    CHECK(point.y == Approx(at.y).margin(1e-6));
  }
}

TEST_CASE("a panorama counts distances, and is taken from the middle of what it is to show") {
  Camera camera = with_panorama(tilted(), Projection::latitude_longitude, 0);
  camera.clip_near = 2;
  camera.clip_far = 9;
  for (const Vec2 frame : {Vec2{0.1f, 0.2f}, {0.8f, 0.9f}}) {
    const Ray ray = camera_ray(camera, frame, {});
    CHECK(length(ray.direction * ray.t_min) == Approx(2).epsilon(rounding));
    CHECK(length(ray.direction * ray.t_max) == Approx(9).epsilon(rounding));
  }
  CHECK(fit_frame(camera, 300, 100).tan_half_width == camera.tan_half_width);
  CHECK(view_whole(camera, {{1, 2, 3}, {3, 4, 9}}).position == Vec3{2, 3, 6});
}

}  // namespace twinray
