// SPDX-License-Identifier: Apache-2.0
#include "io/collada/camera.h"
#include "io/default_camera.h"

#include <cmath>

#include "tests/support/catch.h"
#include "tests/support/collada_text.h"
#include "tests/support/near.h"

namespace twinray {
namespace {

constexpr float camera_tolerance = 1e-6f;

/// `lens` stands within <perspective>, `extra` within <camera>.
std::string camera_text(const std::string& lens, const std::string& transform = "",
                        const std::string& extra = "") {
  return collada_text(
      collada_triangle() +
          "<library_cameras><camera id=\"eye\" name=\"Eye\"><optics><technique_common><perspective>" + lens +
          "</perspective></technique_common></optics>" + extra + "</camera></library_cameras>",
      collada_shape_node() + "<node>" + transform + "<instance_camera url=\"#eye\"/></node>");
}

LoadedScene load_camera(const std::string& lens, const std::string& transform = "",
                        const LoadOptions& options = {}) {
  return load_collada(camera_text(lens, transform), options);
}

Camera lens(const std::string& elements) { return load_camera(elements).scene.camera; }

/// Half of the frame, in units of the distance to it.
void check_frame(const Camera& camera, double half_width, double half_height) {
  CHECK(camera.tan_half_width == Approx(half_width));
  CHECK(camera.tan_half_height == Approx(half_height));
}

}  // namespace

TEST_CASE("each legal pair of field and aspect gives the frame") {
  const Camera by_x = lens("<xfov>90</xfov><aspect_ratio>2</aspect_ratio>");
  check_frame(by_x, 1, 0.5);
  const Camera both = lens("<xfov>90</xfov><yfov>53.13010235</yfov>");
  check_frame(both, 1, 0.5);
}

TEST_CASE("a height is kept where the image has another shape than the aspect ratio") {
  const Camera square = fit_frame(lens("<yfov>90</yfov><aspect_ratio>2</aspect_ratio>"), 100, 100);
  check_frame(square, 1, 1);
  const Camera wide = fit_frame(lens("<yfov>90</yfov><aspect_ratio>2</aspect_ratio>"), 200, 100);
  check_frame(wide, 2, 1);
}

TEST_CASE("with one field alone the image's shape decides the other") {
  const Camera wide = fit_frame(lens("<xfov>90</xfov>"), 400, 100);
  check_frame(wide, 1, 0.25);
  const Camera tall = fit_frame(lens("<yfov>90</yfov>"), 400, 100);
  check_frame(tall, 4, 1);
}

TEST_CASE("a lens is shifted as Blender's exporter says it: by parts of the longer side") {
  const auto center_of = [](const std::string& lens, const std::string& profile, const std::string& shift) {
    const std::string extra =
        "<extra><technique profile=\"" + profile + "\">" + shift + "</technique></extra>";
    return load_collada(camera_text(lens, "", extra)).scene.camera.frame_center;
  };
  const std::string wide = "<xfov>90</xfov><aspect_ratio>2</aspect_ratio>",
                    tall = "<xfov>90</xfov><aspect_ratio>0.5</aspect_ratio>",
                    shift = "<shiftx>0.25</shiftx><shifty>-0.5</shifty>";
  CHECK(center_of(wide, "blender", shift) == Vec2{0.5f, -1});
  CHECK(center_of(tall, "blender", shift) == Vec2{1, -2});
  CHECK(center_of(wide, "blender", "<shifty>0.5</shifty>") == Vec2{0, 1});
  CHECK(center_of(wide, "other", shift) == Vec2{0, 0});
  CHECK_THROWS_WITH(center_of(wide, "blender", "<shiftx>11</shiftx>"), Catch::Contains("<shiftx>"));
}

TEST_CASE("a camera stands and turns with its node") {
  const Camera camera =
      load_camera("<xfov>40</xfov>",
                  "<translate>1 2 3</translate><rotate>0 1 0 90</rotate><scale>3 2 5</scale>")
          .scene.camera;
  CHECK(camera.position == Vec3{1, 2, 3});
  test::check_near(camera.forward, {-1, 0, 0});
  test::check_near(camera.up, {0, 1, 0});
  test::check_near(camera.right, {0, 0, -1});
}

TEST_CASE("a camera's axes are orthonormal under a skew, and keep their view") {
  const Camera camera =
      load_camera("<xfov>40</xfov>", "<matrix>1 0.25 0 0  0 1 0.5 0  0 0 1 0  0 0 0 1</matrix>").scene.camera;
  CHECK(std::fabs(dot(camera.up, camera.forward)) < camera_tolerance);
  CHECK(std::fabs(dot(camera.right, camera.forward)) < camera_tolerance);
  CHECK(std::fabs(dot(camera.right, camera.up)) < camera_tolerance);
  test::check_near(camera.forward, normalize(Vec3{0, -0.5f, -1}));
  test::check_near(cross(camera.right, camera.up), -camera.forward);
}

TEST_CASE("a mirrored camera stays mirrored") {
  const Camera camera = load_camera("<xfov>40</xfov>", "<scale>-1 1 1</scale>").scene.camera;
  test::check_near(camera.right, {-1, 0, 0});
  test::check_near(camera.up, {0, 1, 0});
  test::check_near(camera.forward, {0, 0, -1});
}

TEST_CASE("a note says where clip distances would have cut something, and are not used") {
  const auto notes = [](const std::string& distances, const LoadOptions& options = {}) {
    return load_camera("<xfov>40</xfov>" + distances, "<translate>0 0 5</translate>", options).summary.notes;
  };
  CHECK(
      notes("<znear>1</znear><zfar>4</zfar>") ==
      std::vector<std::string>{"the camera's clip distances, znear 1 and zfar 4, are not used: parts of the "
                               "scene are nearer or farther; --clip=file cuts them off"});
  CHECK(notes("<znear>6</znear><zfar>7</zfar>").size() == 1);
  CHECK(notes("<znear>1</znear><zfar>5</zfar>").empty());
  CHECK(notes("<znear>nan</znear>").empty());
  CHECK(notes("<znear>1</znear><zfar>4</zfar>", {.clip_as_file = true}).empty());
}

TEST_CASE("clip distances are read where they are asked for, and else nothing is clipped") {
  const LoadOptions as_file{.clip_as_file = true};
  const std::string cut = "<xfov>40</xfov><znear>0.5</znear><zfar>20</zfar>";
  const Camera clipped = load_camera(cut, "", as_file).scene.camera;
  CHECK(clipped.clip_near == 0.5f);
  CHECK(clipped.clip_far == 20);
  for (const Camera& open : {load_camera("<xfov>40</xfov>", "", as_file).scene.camera, lens(cut),
                             lens("<xfov>40</xfov><znear>nan</znear><zfar>-1</zfar>")}) {
    CHECK(open.clip_near == 0);
    CHECK(std::isinf(open.clip_far));
  }
  const std::string error =
      collada_error(camera_text("<xfov>40</xfov><znear>2</znear><zfar>1</zfar>"), as_file);
  CHECK(error.find(": <znear> is 2 and <zfar> 1; znear must be the smaller one\n") != std::string::npos);
}

TEST_CASE("without a camera a default one sees all of the scene") {
  const LoadedScene loaded =
      load_collada(collada_text(collada_triangle(), collada_shape_node("<translate>50 60 70</translate>")));
  const Camera& camera = loaded.scene.camera;
  for (const Vec3& p : mesh_of(loaded).positions) {
    const Vec3 d = p - camera.position;
    const float depth = dot(d, camera.forward);
    CHECK(depth > 0);
    CHECK(std::fabs(dot(d, camera.right)) < depth * camera.tan_half_width);
    CHECK(std::fabs(dot(d, camera.up)) < depth * camera.tan_half_height);
  }
  test::check_near(cross(camera.right, camera.up), -camera.forward);
  CHECK(loaded.summary.camera.empty());
  CHECK(summary_lines(loaded.summary)[1] ==
        "camera: none in the file; a default one sees the whole scene from the front, right and above");
}

TEST_CASE("a default camera sees a box of any shape whole, and none of its faces edge on") {
  constexpr float edge_on = 0.3f;  // least cosine between the view and the normal of a face that it shows
  for (const Vec3 half :
       {Vec3{1, 1, 1}, Vec3{100, 1, 1}, Vec3{1, 0, 1}, Vec3{1e-3f, 1e-3f, 1e-2f}, Vec3{1, 1, 1e6f}}) {
    const Vec3 center{50, 60, 70};
    const Camera camera = default_camera({center - half, center + half});
    const Vec3 back = -camera.forward;
    CHECK(std::min({back.x, back.y, back.z}) > edge_on);
    CHECK(camera.right.y == 0);
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 p{corner & 1 ? half.x : -half.x, corner & 2 ? half.y : -half.y,
                   corner & 4 ? half.z : -half.z};
      const Vec3 d = center + p - camera.position;
      const float depth = dot(d, camera.forward);
      CHECK(std::fabs(dot(d, camera.right)) < depth * camera.tan_half_width);
      CHECK(std::fabs(dot(d, camera.up)) < depth * camera.tan_half_height);
    }
  }
}

}  // namespace twinray
