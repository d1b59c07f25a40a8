// SPDX-License-Identifier: Apache-2.0
#include "cli/frame_note.h"

#include "tests/support/catch.h"

namespace twinray::test {
namespace {

/// Looks from the origin along -z; the frame is 2 wide and 2 high at distance 1.
const Camera camera{.tan_half_width = 1, .tan_half_height = 1};

Geometry triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
  return Geometry({Mesh{.name = "one", .positions = {a, b, c, {900, 900, 900}}, .triangles = {{0, 1, 2}}}});
}

Geometry sphere(const Vec3& center, float radius) {
  return Geometry({SphereSet{.name = "ball", .spheres = {{center, radius}}}});
}

}  // namespace

TEST_CASE("a triangle is in view as a whole, in part or not at all by its corners, not by its box") {
  CHECK(in_view(camera, triangle({-1, -1, -2}, {1, -1, -2}, {0, 1, -2})) == InView::whole);
  CHECK(in_view(camera, triangle({-3, -1, -2}, {1, -1, -2}, {0, 1, -2})) == InView::part);
  CHECK(in_view(camera, triangle({-1, -1, 2}, {1, -1, 2}, {0, 1, 2})) == InView::nothing);
  // Its box has corners outside of the frame, for the triangle leans along the frame's edge.
  CHECK(in_view(camera, triangle({-0.9f, 0, -1}, {-3.9f, 0, -4}, {0, 0, -4})) == InView::whole);
  // It fills the frame with all three corners outside.
  CHECK(in_view(camera, triangle({-90, -90, -2}, {90, -90, -2}, {0, 90, -2})) == InView::part);
  // Two of its corners are on two sides of the frame, and yet it passes by: its box does not.
  CHECK(in_view(camera, triangle({-4, 1, -2}, {1, -4, -2}, {-4, -4, -2})) == InView::part);
  CHECK(in_view(camera, triangle({-5, 0, -2}, {0, -5, -2}, {-5, -5, -2})) == InView::nothing);
  // One corner is behind the camera.
  CHECK(in_view(camera, triangle({0, 0, 2}, {-3, 0, -1}, {0, -3, -1})) == InView::nothing);
  CHECK(in_view(camera, triangle({0, 0, 2}, {-0.5f, 0, -1}, {0, -0.5f, -1})) == InView::part);
}

TEST_CASE("clip distances end the view, and a vertex that no triangle has does not matter") {
  Camera clipped = camera;
  clipped.clip_near = 1;
  clipped.clip_far = 3;
  CHECK(in_view(clipped, triangle({0, 0, -1}, {1, 0, -3}, {0, 1, -3})) == InView::whole);
  CHECK(in_view(clipped, triangle({0, 0, -0.9f}, {1, 0, -3}, {0, 1, -3})) == InView::part);
  CHECK(in_view(clipped, triangle({0, 0, -4}, {1, 0, -4}, {0, 1, -4})) == InView::nothing);
}

TEST_CASE("a sphere is in view where it touches no side of the frame, and not where it is beyond one") {
  CHECK(in_view(camera, sphere({0, 0, -2}, 1)) == InView::whole);
  CHECK(in_view(camera, sphere({0, 0, -2}, 1.42f)) == InView::part);
  CHECK(in_view(camera, sphere({-5, 0, -2}, 2)) == InView::nothing);
  CHECK(in_view(camera, sphere({0, 0, 2}, 1)) == InView::nothing);
}

TEST_CASE("a note is made of what is out of view, and none of a scene without shapes") {
  CHECK(frame_note(camera, Geometry()).empty());
  CHECK(frame_note(camera, sphere({0, 0, -2}, 1)).empty());
  CHECK(frame_note(camera, sphere({0, 0, -2}, 1.5f)) ==
        "part of the scene lies outside of the frame; --view=whole shows all of it");
  CHECK(frame_note(camera, sphere({0, 0, 2}, 1)) ==
        "the frame shows nothing of the scene; --view=whole shows all of it");
}

TEST_CASE("the view of an orthographic camera is a box") {
  Camera parallel = camera;
  parallel.projection = Projection::orthographic;
  CHECK(in_view(parallel, triangle({-1, -1, -90}, {1, -1, -90}, {0, 1, -90})) == InView::whole);
  CHECK(in_view(parallel, triangle({-1.1f, -1, -90}, {1, -1, -90}, {0, 1, -90})) == InView::part);
  CHECK(in_view(parallel, triangle({2, 0, -90}, {3, 0, -90}, {2, 1, -90})) == InView::nothing);
  CHECK(in_view(parallel, triangle({-1, -1, 1}, {1, -1, 1}, {0, 1, 1})) == InView::nothing);
}

TEST_CASE("the view of a shifted frame lies beside the axis, and a panorama sees all") {
  Camera shifted = camera;
  shifted.frame_center = {2, 0};  // From x = 1 to 3 at the distance 1.
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    shifted.projection = projection;
    CHECK(in_view(shifted, triangle({1.1f, 0, -1}, {2.9f, 0, -1}, {2, 0.9f, -1})) == InView::whole);
    CHECK(in_view(shifted, triangle({0.9f, 0, -1}, {2.9f, 0, -1}, {2, 0.9f, -1})) == InView::part);
    CHECK(in_view(shifted, triangle({-0.5f, 0, -1}, {0.5f, 0, -1}, {0, 0.9f, -1})) == InView::nothing);
  }
  shifted.projection = Projection::fisheye;
  CHECK(in_view(shifted, triangle({-1, -1, 1}, {1, -1, 1}, {0, 1, 1})) == InView::whole);
}

}  // namespace twinray::test
