// SPDX-License-Identifier: Apache-2.0
// What moves in a file of pbrt's, at one time and another.
#include <optional>
#include <string>

#include "core/geometry.h"
#include "tests/support/catch.h"
#include "tests/support/pbrt_text.h"

namespace twinray::test {
namespace {

constexpr float motion_rounding = 1e-5f;

LoadedScene loaded_at(std::optional<double> time, const std::string& text) {
  return load_pbrt_text(text, {.time = time});
}

/// The second corner of the scene's triangle.
Vec3 corner_at(std::optional<double> time, const std::string& transforms, const std::string& before = "") {
  return loaded_at(time, before + "WorldBegin " + transforms + " " + pbrt_triangle)
      .scene.geometry->mesh(0)
      ->positions[1];
}

bool is_near(const Vec3& a, const Vec3& b) { return length(a - b) < motion_rounding * (1 + length(b)); }

const std::string sliding = "ActiveTransform EndTime Translate 4 0 0 ActiveTransform All";

}  // namespace

TEST_CASE("pbrt's shapes move evenly from where they begin, and stand before and after") {
  CHECK(is_near(corner_at({}, sliding), {1, 0, 0}));
  CHECK(is_near(corner_at(-1, sliding), {1, 0, 0}));
  CHECK(is_near(corner_at(0.25, sliding), {2, 0, 0}));
  CHECK(is_near(corner_at(1, sliding), {5, 0, 0}));
  CHECK(is_near(corner_at(7, sliding), {5, 0, 0}));
  CHECK(is_near(corner_at(3, sliding, "TransformTimes 2 4 "), {3, 0, 0}));
  CHECK(is_near(corner_at(0.5, "Translate 0 1 0 " + sliding + " Scale 2 2 2"), {4, 1, 0}));
  CHECK(is_near(corner_at(0.5, "ActiveTransform StartTime Rotate -90 0 0 1 ActiveTransform All"),
                {0.70710678f, -0.70710678f, 0}));
}

TEST_CASE("without a time pbrt's scene is that of the moment at which the shutter opens") {
  const std::string camera = "Camera \"perspective\" \"float shutteropen\" 0.25 \"float shutterclose\" 2 ";
  CHECK(is_near(corner_at({}, sliding, camera), {2, 0, 0}));
  CHECK(is_near(corner_at(1, sliding, camera), {5, 0, 0}));
  CHECK(is_near(
      corner_at({}, "CoordSysTransform \"a\"", sliding + " CoordinateSystem \"a\" Identity " + camera),
      {2, 0, 0}));
  const std::string moving = "ActiveTransform EndTime Translate -4 0 0 ActiveTransform All " + camera;
  CHECK(is_near(load_pbrt_text(moving + "WorldBegin " + pbrt_triangle).scene.camera.position, {1, 0, 0}));
}

TEST_CASE("what pbrt's file undoes for both ends stands still") {
  const LoadedScene still =
      loaded_at(0.5, "WorldBegin AttributeBegin " + sliding + " Identity " + pbrt_triangle + " AttributeEnd");
  CHECK(is_near(still.scene.geometry->mesh(0)->positions[1], {1, 0, 0}));
  CHECK(is_near(corner_at(0.5, "AttributeBegin " + sliding + " AttributeEnd"), {1, 0, 0}));
  CHECK(is_near(corner_at(0.5, "AttributeBegin " + sliding +
                                   " CoordinateSystem \"a\" AttributeEnd "
                                   "CoordSysTransform \"a\""),
                {3, 0, 0}));
}

TEST_CASE("pbrt's instances and lights move as shapes do") {
  const std::string instance =
      "WorldBegin ObjectBegin \"o\" " + pbrt_triangle + " ObjectEnd " + sliding + " ObjectInstance \"o\"";
  for (const InstanceUse use : {InstanceUse::keep, InstanceUse::copy}) {
    const Aabb bounds = load_pbrt_text(instance, {.time = 0.5, .instances = use}).scene.geometry->bounds();
    CHECK(bounds.lower.x == Approx(2).margin(1e-4));
    CHECK(bounds.upper.x == Approx(3).margin(1e-4));
  }
  const LoadedScene lit = loaded_at(0.5, "WorldBegin " + sliding + " LightSource \"point\"");
  CHECK(is_near(std::get<PointLight>(lit.scene.lights[0].source).position, {2, 0, 0}));
}

TEST_CASE("pbrt's camera moves in the world, and so does its space") {
  // From 0 0 -4, turned by 90 degrees about the world's y, to 4 0 0.
  const std::string camera =
      "Translate 0 0 4 ActiveTransform EndTime Rotate 90 0 1 0 ActiveTransform All "
      "Camera \"perspective\" WorldBegin ";
  const auto position = [&](double time) { return loaded_at(time, camera).scene.camera.position; };
  CHECK(is_near(position(0), {0, 0, -4}));
  const Vec3 end = position(1), middle = position(0.5);
  CHECK(length(end) == Approx(4));
  CHECK(std::fabs(end.x) == Approx(4));
  CHECK(is_near(middle, (Vec3{0, 0, -4} + end) * 0.5f));  // It is moved evenly, and turned beside that.
  const Vec3 corner = loaded_at(1, camera + "CoordSysTransform \"camera\" " + pbrt_triangle)
                          .scene.geometry->mesh(0)
                          ->positions[0];
  CHECK(is_near(corner, end));
}

TEST_CASE("the shutter of pbrt's camera is told where something moves, and only there") {
  const auto shutter = [](const std::string& before, const std::string& world) {
    return load_pbrt_text(before + " WorldBegin " + world + " " + pbrt_triangle).defaults.shutter;
  };
  const std::string camera = "Camera \"perspective\" \"float shutteropen\" 0.25 \"float shutterclose\" 0.75";
  CHECK(shutter(camera, sliding) == Shutter{0.25, 0.75});
  CHECK(shutter("", sliding) == Shutter{0, 1});
  CHECK(shutter("", sliding + " Shape \"sphere\" Identity") == Shutter{0, 1});
  CHECK(!shutter(camera, ""));
  CHECK(
      !shutter(camera, "ActiveTransform StartTime Translate 1 0 0 ActiveTransform EndTime Translate 1 0 0"));
  CHECK(shutter("ActiveTransform EndTime Translate 1 0 0 " + camera, "").has_value());
  const LoadedScene loaded = loaded_at(0.5, "TransformTimes 1 3 WorldBegin " + sliding + " " + pbrt_triangle);
  REQUIRE(loaded.summary.animation);
  CHECK(loaded.summary.animation->first == 1);
  CHECK(loaded.summary.animation->last == 3);
  CHECK(loaded.summary.animation->shown == 0.5);
  CHECK(loaded.warnings.empty());
}

TEST_CASE("a shutter of pbrt's that closes before it opens, or at once, is an error") {
  const auto fault = [](const char* open, const char* close) {
    return error_text([&] {
      load_pbrt_text(std::string("Camera \"perspective\" \"float shutteropen\" ") + open +
                     " \"float shutterclose\" " + close + " WorldBegin");
    });
  };
  CHECK(fault("0", "1").empty());
  CHECK(fault("1", "1").find("the shutter closes when it opens, or before: no light gets in") !=
        std::string::npos);
  CHECK(fault("1", "0.5").find("no light gets in") != std::string::npos);
}

}  // namespace twinray::test
