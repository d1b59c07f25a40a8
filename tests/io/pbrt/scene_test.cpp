// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/scene.h"

#include <fmt/format.h>

#include <cmath>

#include "core/angle.h"
#include "core/error.h"
#include "core/mesh_area.h"
#include "core/surface.h"
#include "tests/support/catch.h"
#include "tests/support/pbrt_text.h"

namespace twinray {
namespace {

using test::load_pbrt_text;
using test::load_pbrt_world;
using test::pbrt_triangle;

constexpr float rounding = 1e-5f;  // of a chain of transforms in double, rounded once

/// The normal of the first triangle's front.
Vec3 front(const LoadedScene& loaded) { return loaded.scene.geometry->facet(0, 0).normal; }

bool near(const Vec3& a, const Vec3& b) { return length(a - b) < rounding * (1 + length(b)); }

Camera camera_of(const std::string& before, const std::string& camera = "Camera \"perspective\"") {
  return load_pbrt_text(before + "\n" + camera + "\nWorldBegin\n" + pbrt_triangle).scene.camera;
}

std::string message_of(const std::string& text) {
  try {
    load_pbrt_text(text);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

double area(const Mesh& mesh) {
  double sum = 0;
  for (const Triangle& triangle : mesh.triangles) sum += area_vector(mesh, triangle).area();
  return sum;
}

}  // namespace

TEST_CASE("the front of a triangle is pbrt's outside, through every turn and mirror") {
  const Vec3 up{0, 0, 1}, down{0, 0, -1};
  CHECK(near(front(load_pbrt_world(pbrt_triangle)), up));
  CHECK(near(front(load_pbrt_world("ReverseOrientation " + pbrt_triangle)), down));
  CHECK(near(front(load_pbrt_world("Scale -1 1 1 " + pbrt_triangle)), up));
  CHECK(near(front(load_pbrt_world("Scale 1 1 -1 " + pbrt_triangle)), down));
  CHECK(near(front(load_pbrt_world("Scale -1 1 1 ReverseOrientation " + pbrt_triangle)), down));
  CHECK(near(front(load_pbrt_world("Rotate 180 1 0 0 " + pbrt_triangle)), down));
}

TEST_CASE("loopsubdiv is divided as often as it says, and its vertices are on the limit surface") {
  const std::string tetrahedron =
      "\"point3 P\" [ 1 1 1  1 -1 -1  -1 1 -1  -1 -1 1 ] \"integer indices\" [ 0 1 2  0 3 1  0 2 3  1 3 2 ]";
  const auto mesh_of = [&](const std::string& more) {
    return *load_pbrt_world("Shape \"loopsubdiv\" " + tetrahedron + more).scene.geometry->mesh(0);
  };
  CHECK(mesh_of("").triangles.size() == 4 * 64);
  CHECK(mesh_of(" \"integer levels\" 1").triangles.size() == 16);
  const Mesh coarse = mesh_of(" \"integer levels\" 0");
  REQUIRE(coarse.triangles.size() == 4);
  // Three neighbours: half of a vertex' limit is its own, and they are its opposite in sum.
  CHECK(near(coarse.positions[0], {1.0f / 5, 1.0f / 5, 1.0f / 5}));
  // pbrt's outside is where the control mesh's corners appear clockwise: here, within the tetrahedron.
  CHECK(near(coarse.normals[0], normalize(Vec3{-1, -1, -1})));
  const LoadedScene lit = load_pbrt_world("AreaLightSource \"diffuse\" Shape \"loopsubdiv\" " + tetrahedron);
  CHECK(dot(front(lit), lit.scene.geometry->mesh(0)->positions[0]) < 0);
}

TEST_CASE("tangents of a pbrt mesh are named, since they are not rendered") {
  const LoadedScene loaded = load_pbrt_world(
      "Shape \"trianglemesh\" \"point3 P\" [ 0 0 0  1 0 0  0 1 0 ] \"vector3 S\" [ 1 0 0  1 0 0  1 0 0 ]");
  REQUIRE(loaded.warnings.size() == 1);
  CHECK(loaded.warnings[0].message.find("tangents are not rendered") != std::string::npos);
}

TEST_CASE("a loopsubdiv that is no surface is shown as it is, and one that grows too large is an error") {
  const std::string fins =
      "Shape \"loopsubdiv\" \"point3 P\" [ 0 0 0  1 0 0  0 1 0  0 0 1  0 -1 0 ] \"integer indices\" "
      "[ 0 1 2  0 1 3  0 1 4 ]";
  const LoadedScene loaded = load_pbrt_world(fins);
  CHECK(loaded.scene.geometry->mesh(0)->triangles.size() == 3);
  CHECK(loaded.warnings.at(0).message.find("this control mesh is no surface") != std::string::npos);
  CHECK(message_of("WorldBegin\n" + fins + " \"integer levels\" 13")
            .find("\"levels\" is 13; it must lie in [0, 12]") != std::string::npos);
  std::string many = "WorldBegin\nShape \"loopsubdiv\" \"integer levels\" 12 \"point3 P\" [";
  for (int i = 0; i < 30; ++i) many += " " + std::to_string(i) + " 0 0";
  many += "] \"integer indices\" [";
  for (int i = 0; i + 2 < 30; i += 3) many += fmt::format(" {} {} {}", i, i + 1, i + 2);
  CHECK(message_of(many + "]").find("12 levels of 10 triangles make 167772160; at most 16777216 are valid") !=
        std::string::npos);
}

TEST_CASE("shading normals say which side is outside, whatever the winding") {
  const std::string with_normals =
      "Shape \"trianglemesh\" \"point3 P\" [ 0 0 0  1 0 0  0 1 0 ] \"normal N\" [ 0 0 -1  0 0 -1  0 0 -2 ]";
  const LoadedScene loaded = load_pbrt_world(with_normals);
  CHECK(near(front(loaded), {0, 0, -1}));
  for (const Vec3& n : loaded.scene.geometry->mesh(0)->normals) CHECK(near(n, {0, 0, -1}));
  CHECK(near(front(load_pbrt_world("ReverseOrientation " + with_normals)), {0, 0, 1}));
  CHECK(near(front(load_pbrt_world("Scale -1 1 1 " + with_normals)), {0, 0, -1}));
  CHECK(near(front(load_pbrt_world("Scale 1 1 -1 " + with_normals)), {0, 0, 1}));
}

TEST_CASE("normals without a direction are those of their triangles") {
  const LoadedScene loaded = load_pbrt_world(
      "Shape \"trianglemesh\" \"point3 P\" [ 0 0 0  1 0 0  0 1 0 ] \"normal N\" [ 0 0 1  0 0 0  0 0 1 ]");
  const Mesh& mesh = *loaded.scene.geometry->mesh(0);
  CHECK(near(mesh.normals[mesh.normal_indices[0][1]], {0, 0, 1}));
  CHECK(loaded.summary.notes.size() == 1);
}

TEST_CASE("transforms multiply from the right, and Transform takes columns") {
  const auto corner = [](const std::string& transforms) {
    return load_pbrt_world(transforms + " " + pbrt_triangle).scene.geometry->mesh(0)->positions[1];
  };
  CHECK(near(corner("Translate 1 2 3 Scale 2 3 4"), {3, 2, 3}));
  CHECK(near(corner("Scale 2 3 4 Translate 1 2 3"), {4, 6, 12}));
  CHECK(near(corner("Rotate 90 0 0 1"), {0, 1, 0}));
  CHECK(near(corner("Transform [ 0 1 0 0  -1 0 0 0  0 0 1 0  5 6 7 1 ]"), {5, 7, 7}));
  CHECK(near(corner("Translate 1 0 0 ConcatTransform [ 2 0 0 0  0 2 0 0  0 0 2 0  0 0 0 1 ]"), {3, 0, 0}));
  CHECK(near(corner("Translate 1 0 0 CoordinateSystem \"a\" Identity CoordSysTransform \"a\""), {2, 0, 0}));
  CHECK(
      near(corner("ActiveTransform EndTime Translate 9 9 9 ActiveTransform All Translate 1 0 0"), {2, 0, 0}));
}

TEST_CASE("a number at the end of its range is within it") {
  CHECK(load_pbrt_text("PixelFilter \"gaussian\" \"float sigma\" 0.01 WorldBegin").defaults.filter->sigma ==
        0.01f);
  CHECK(load_pbrt_text("Film \"rgb\" \"float iso\" 1e-6 WorldBegin LightSource \"point\"")
            .scene.lights.size() == 1);
}

TEST_CASE("the picture that a patch is sampled by is no news") {
  const std::string patch =
      "Shape \"bilinearmesh\" \"point3 P\" [ 0 0 0  1 0 0  0 1 0  1 1 0 ] \"string emissionfilename\" "
      "\"a.png\"";
  CHECK(load_pbrt_world(patch).warnings.empty());
}

TEST_CASE("LookAt and a perspective camera give pbrt's picture: left-handed, the shorter side has the fov") {
  const Camera camera = camera_of(
      "LookAt 0 0 5  0 0 0  0 1 0 Film \"rgb\" \"integer xresolution\" 200 "
      "\"integer yresolution\" 100",
      "Camera \"perspective\" \"float fov\" 90");
  CHECK(near(camera.position, {0, 0, 5}));
  CHECK(near(camera.forward, {0, 0, -1}));
  CHECK(near(camera.up, {0, 1, 0}));
  CHECK(near(camera.right, {-1, 0, 0}));  // pbrt's space is left-handed
  CHECK(camera.tan_half_height == Approx(1));
  CHECK(camera.tan_half_width == Approx(2));
  CHECK_FALSE(camera.is_stretched);
  CHECK(near(camera_of("Scale -1 1 1 LookAt 0 0 5  0 0 0  0 1 0").right, {1, 0, 0}));
}

TEST_CASE("the space of the camera has a name to go back to") {
  const LoadedScene loaded = load_pbrt_text(
      "Translate 0 0 -5\nCamera \"perspective\"\nWorldBegin\n"
      "CoordSysTransform \"camera\"\n" +
      pbrt_triangle);
  CHECK(loaded.scene.geometry->bounds().lower == Vec3{0, 0, 5});
}

TEST_CASE("lens, screen window and frame's shape are read") {
  const std::string film = "Film \"rgb\" \"integer xresolution\" 100 \"integer yresolution\" 100";
  const Camera lens = camera_of(film + " Scale 2 2 2",
                                "Camera \"perspective\" \"float lensradius\" 4 \"float focaldistance\" 6");
  CHECK(lens.lens_radius == Approx(2));
  CHECK(lens.focal_distance == Approx(3));
  const auto warnings_under = [&](const std::string& transform) {
    const std::string camera = " Camera \"perspective\" \"float lensradius\" 4 WorldBegin ";
    return load_pbrt_text(film + transform + camera + pbrt_triangle).warnings.size();
  };
  CHECK(warnings_under(" Scale -2 2 1") == 0);
  CHECK(warnings_under(" Scale 1 2 1") == 1);
  const auto error_of_window = [&](const std::string& numbers) {
    try {
      camera_of(film, "Camera \"orthographic\" \"float screenwindow\" [ " + numbers + " ]");
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(error_of_window("1 -1 -1 1")
            .find("goes from 1 to -1 in x and from -1 to 1 in y; valid is from the smaller") !=
        std::string::npos);
  CHECK(error_of_window("1 2 3").find("\"screenwindow\" needs four numbers") != std::string::npos);
  const Camera window = camera_of(film, "Camera \"orthographic\" \"float screenwindow\" [ -3 3 -2 2 ]");
  CHECK(window.projection == Projection::orthographic);
  CHECK(window.tan_half_width == Approx(3));
  CHECK(window.tan_half_height == Approx(2));
  CHECK(window.is_stretched);
  CHECK(camera_of(film, "Camera \"perspective\" \"float frameaspectratio\" 0.5").tan_half_height ==
        Approx(2));
}

TEST_CASE("a camera that is scaled along one side stretches what it sees") {
  const std::string film = "Film \"rgb\" \"integer xresolution\" 100 \"integer yresolution\" 100";
  for (const char* kind : {"perspective", "orthographic"}) {
    const Camera camera = camera_of(film + " Scale 1 2 1", fmt::format("Camera \"{}\"", kind));
    CHECK(camera.tan_half_width == Approx(2 * camera.tan_half_height));
    CHECK(camera.is_stretched);
    CHECK_FALSE(camera_of(film + " Scale 2 2 1", fmt::format("Camera \"{}\"", kind)).is_stretched);
    const std::string wide = fmt::format("Camera \"{}\" \"float frameaspectratio\" 3", kind);
    CHECK(camera_of(film, wide).is_stretched);
    CHECK_FALSE(camera_of("", wide).is_stretched);  // The picture's shape follows the frame.
  }
}

TEST_CASE("a screen window beside the axis of view shifts the frame") {
  const std::string film = "Film \"rgb\" \"integer xresolution\" 100 \"integer yresolution\" 100";
  const Camera camera =
      camera_of(film + " Scale 1 1 2", "Camera \"perspective\" \"float screenwindow\" [ 0 2 -3 -1 ]");
  // Space is flattened along the view, so the frame at the distance 1 is as much larger.
  CHECK(camera.frame_center.x == Approx(2));
  CHECK(camera.frame_center.y == Approx(-4));
  CHECK(camera.tan_half_width == Approx(2));
  CHECK_FALSE(camera.is_stretched);
  const Camera flat = camera_of(film, "Camera \"orthographic\" \"float screenwindow\" [ 1 2 -3 3 ]");
  CHECK(flat.frame_center == Vec2{1.5f, 0});
}

TEST_CASE("a spherical camera gives pbrt's picture: its first column looks to the right, then ahead") {
  const std::string look = "LookAt 0 0 5  0 0 0  0 1 0", camera = "Camera \"spherical\" \"string mapping\" ";
  const auto seen = [](const Camera& from, Vec2 frame) { return camera_ray(from, frame, {}).direction; };
  // Right is -x here, ahead -z.
  const Camera around = camera_of(look, camera + "\"equirectangular\"");
  CHECK(around.position == Vec3{0, 0, 5});
  CHECK(near(seen(around, {0, 0.5f}), {-1, 0, 0}));
  CHECK(near(seen(around, {0.25f, 0.5f}), {0, 0, -1}));
  CHECK(near(seen(around, {0.5f, 0.5f}), {1, 0, 0}));
  CHECK(near(seen(around, {0.1f, 0}), {0, 1, 0}));
  // The square lies around +y; x grows to the right, y ahead.
  for (const std::string& text : {camera + "\"equalarea\"", std::string("Camera \"spherical\"")}) {
    const Camera square = camera_of(look, text);
    CHECK(square.projection == Projection::equal_area);
    CHECK(near(seen(square, {0.5f, 0.5f}), {0, 1, 0}));
    CHECK(near(seen(square, {1, 0.5f}), {-1, 0, 0}));
    CHECK(near(seen(square, {0.5f, 1}), {0, 0, -1}));
  }
}

TEST_CASE("a file that ends before its world describes no scene") {
  for (const std::string text : {"", "# nothing", "Camera \"perspective\"\nFilm \"rgb\"\n"})
    CHECK(message_of(text).find("the file ends before WorldBegin: it describes no scene") !=
          std::string::npos);
  CHECK(message_of("Camera \"perspective\"\n").starts_with("scene.pbrt:2:1: "));
  CHECK(message_of("WorldBegin").empty());
}

TEST_CASE("of two statements about the picture the second one counts, with a warning") {
  const LoadedScene loaded = load_pbrt_text(
      "Film \"rgb\" \"integer xresolution\" 10\nFilm \"rgb\" \"integer xresolution\" 20\n"
      "Camera \"orthographic\"\nCamera \"perspective\"\nSampler \"sobol\"\nAccelerator \"bvh\" Accelerator "
      "\"bvh\"\n"
      "WorldBegin");
  CHECK(loaded.defaults.resolution->width == 20);
  CHECK(loaded.scene.camera.projection == Projection::perspective);
  REQUIRE(loaded.warnings.size() == 2);
  CHECK(loaded.warnings[0].message == "a further Film: it replaces that of line 1");
  CHECK(loaded.warnings[1].message == "a further Camera: it replaces that of line 3");
}

TEST_CASE("cameras that are not rendered are refused in plain words") {
  const std::string valid = "; valid are perspective, orthographic, realistic and spherical";
  CHECK(message_of("Camera \"round\"").starts_with("scene.pbrt:1:1: there is no camera \"round\"" + valid));
  CHECK(message_of("Camera \"spherical\" \"string mapping\" \"flat\"")
            .find("there is no mapping \"flat\"; valid are equalarea and equirectangular") !=
        std::string::npos);
  CHECK(message_of("Scale 0 1 1 Camera \"perspective\" WorldBegin")
            .find("the transform of this camera flattens what it sees") != std::string::npos);
}

TEST_CASE("pixel filters are read with pbrt's names and defaults") {
  const auto filter = [](const std::string& text) {
    return load_pbrt_text("PixelFilter " + text + " WorldBegin").defaults.filter;
  };
  CHECK(*filter("\"box\"") == PixelFilter{});
  CHECK(*filter("\"triangle\"") == filter_of_radius(FilterKind::triangle, 2));
  CHECK(*filter("\"gaussian\"") == usual_filter(FilterKind::gaussian));
  const PixelFilter wide =
      *filter("\"gaussian\" \"float xradius\" 2 \"float yradius\" 3 \"float sigma\" 0.75");
  CHECK(wide.radius == Vec2{2, 3});
  CHECK(wide.sigma == 0.75f);
  const PixelFilter sharp = *filter("\"mitchell\" \"float B\" 0 \"float C\" 0.5");
  CHECK(sharp.kind == FilterKind::mitchell);
  CHECK(sharp.radius == Vec2{2, 2});
  CHECK(sharp.b == 0);
  CHECK(sharp.c == 0.5f);
  CHECK(load_pbrt_text("WorldBegin").defaults.filter == usual_filter(FilterKind::gaussian));
  CHECK(load_pbrt_text("PixelFilter \"box\" Film \"rgb\" WorldBegin").defaults.filter == PixelFilter{});
}

TEST_CASE("filters that are not rendered, or not there, are named") {
  const LoadedScene loaded = load_pbrt_text("PixelFilter \"sinc\" \"float tau\" 2 WorldBegin");
  CHECK(loaded.defaults.filter == usual_filter(FilterKind::gaussian));
  REQUIRE(loaded.warnings.size() == 1);
  CHECK(loaded.warnings[0].message.find("the sinc filter is not rendered") != std::string::npos);
  CHECK(
      message_of("PixelFilter \"cone\" WorldBegin")
          .find("there is no pixel filter \"cone\"; valid are box, gaussian, mitchell, sinc and triangle") !=
      std::string::npos);
  CHECK(message_of("PixelFilter \"mitchell\" \"float B\" 2 WorldBegin")
            .find("\"B\" is 2; it must lie in [0, 1]") != std::string::npos);
}

TEST_CASE("film, sampler and integrator are defaults of the picture") {
  const RenderDefaults defaults =
      load_pbrt_text(
          "Film \"rgb\" \"integer xresolution\" 300 \"integer yresolution\" 200 \"float cropwindow\" "
          "[ 0.5 1 0 0.25 ] Sampler \"halton\" \"integer pixelsamples\" 7 Integrator \"path\" "
          "\"integer maxdepth\" 9 WorldBegin")
          .defaults;
  CHECK(defaults.resolution->width == 300);
  CHECK(defaults.resolution->height == 200);
  CHECK(*defaults.crop == std::array{150, 0, 150, 50});
  const RenderDefaults tenths = load_pbrt_text(
                                    "Film \"rgb\" \"integer xresolution\" 100 \"integer yresolution\" 100 "
                                    "\"float cropwindow\" [ 0.1 0.9 0.2 0.8 ] WorldBegin")
                                    .defaults;
  CHECK(*tenths.crop == std::array{10, 20, 80, 60});
  CHECK(*defaults.samples == 7);
  CHECK(*defaults.max_depth == 9);
  const RenderDefaults none = load_pbrt_text("WorldBegin").defaults;
  CHECK_FALSE((none.resolution || none.crop || none.samples || none.max_depth));
  CHECK(*load_pbrt_text("Sampler \"stratified\" \"integer xsamples\" 3 \"integer ysamples\" 5 WorldBegin")
             .defaults.samples == 15);
}

TEST_CASE("samplers and integrators that pbrt has not are warnings") {
  for (const std::string known : {"Sampler \"zsobol\"", "Integrator \"bdpt\""})
    CHECK(load_pbrt_text(known + " WorldBegin").warnings.empty());
  for (const auto& [statement, name] : {std::pair("Sampler \"random\"", "sampler \"random\""),
                                        std::pair("Integrator \"pth\"", "integrator \"pth\"")}) {
    const LoadedScene loaded = load_pbrt_text(std::string(statement) + " WorldBegin");
    REQUIRE(loaded.warnings.size() == 1);
    CHECK(loaded.warnings[0].message.starts_with(fmt::format("there is no {}; valid are ", name)));
  }
}

TEST_CASE("a part of pbrt's film that lies beyond it, or that is named twice, is a warning") {
  const std::string film = "Film \"rgb\" \"integer xresolution\" 64 \"integer yresolution\" 48 ";
  const auto crop_with = [&](const std::string& words, const std::string& warning) {
    const LoadedScene loaded = load_pbrt_text(film + words + " WorldBegin");
    REQUIRE(loaded.warnings.size() == (warning.empty() ? 0 : 1));
    if (!warning.empty()) CHECK(loaded.warnings[0].message.find(warning) != std::string::npos);
    return *loaded.defaults.crop;
  };
  const char* const beyond = " reaches beyond the film, or ends before it begins";
  using Crop = std::array<int, 4>;
  CHECK(crop_with("\"integer pixelbounds\" [0 64 0 48]", "") == Crop{0, 0, 64, 48});
  CHECK(crop_with("\"integer pixelbounds\" [0 100 0 5]", beyond) == Crop{0, 0, 64, 5});
  CHECK(crop_with("\"float cropwindow\" [-1 0.25 0.5 1]", beyond) == Crop{0, 24, 16, 24});
  CHECK(crop_with("\"float cropwindow\" [0 1 0 1e30]", beyond) == Crop{0, 0, 64, 48});
  CHECK(crop_with("\"float cropwindow\" [0.75 0.25 0.5 1]", beyond) == Crop{16, 24, 32, 24});
  CHECK(crop_with("\"float cropwindow\" [0 0.5 0 1] \"integer pixelbounds\" [0 5 0 5]",
                  "\"pixelbounds\" are not used beside a \"cropwindow\"") == Crop{0, 0, 32, 48});
}

TEST_CASE("a whole sphere stays one where its transform is a similarity") {
  const auto spheres = [](const std::string& statements) {
    return load_pbrt_world(statements + " Shape \"sphere\" \"float radius\" 2")
        .scene.geometry->sphere_count();
  };
  CHECK(spheres("") == 1);
  CHECK(spheres("Translate 1 2 3 Rotate 30 1 1 0 Scale -2 2 2") == 1);
  CHECK(spheres("Scale 1 1 1.1") == 0);
  CHECK(spheres("ReverseOrientation") == 0);
  const LoadedScene scaled = load_pbrt_world("Translate 1 2 3 Scale 2 2 2 Shape \"sphere\"");
  CHECK(scaled.scene.geometry->sphere_set(0)->spheres[0].radius == Approx(2));
  CHECK(scaled.scene.geometry->sphere_set(0)->spheres[0].center == Vec3{1, 2, 3});
}

TEST_CASE("cut shapes have the area of what they stand for, and pbrt's side outside") {
  constexpr double of_cutting = 3e-4;  // 256 edges around
  const auto mesh = [](const std::string& shape) {
    const LoadedScene loaded = load_pbrt_world(shape);
    return *loaded.scene.geometry->mesh(0);
  };
  CHECK(area(mesh("Shape \"disk\" \"float radius\" 3")) == Approx(9 * pi_double).epsilon(of_cutting));
  CHECK(area(mesh("Shape \"disk\" \"float radius\" 3 \"float innerradius\" 2")) ==
        Approx(5 * pi_double).epsilon(of_cutting));
  CHECK(area(mesh("Shape \"cylinder\" \"float radius\" 2 \"float zmin\" 1 \"float zmax\" 4")) ==
        Approx(12 * pi_double).epsilon(of_cutting));
  CHECK(area(mesh("Shape \"sphere\" \"float phimax\" 180")) == Approx(2 * pi_double).epsilon(of_cutting));
  CHECK(area(mesh("Shape \"sphere\" \"float zmin\" 0")) == Approx(2 * pi_double).epsilon(of_cutting));
  CHECK(near(front(load_pbrt_world("Shape \"disk\"")), {0, 0, 1}));
  const Mesh ball = mesh("Shape \"sphere\" \"float zmin\" -0.5");
  for (std::size_t i = 0; i < ball.triangles.size(); i += 97) {
    const auto& [a, b, c] = ball.triangles[i];
    const Vec3 n = cross(ball.positions[b] - ball.positions[a], ball.positions[c] - ball.positions[a]);
    CHECK(dot(n, ball.positions[a]) > 0);
  }
}

TEST_CASE("a bilinear patch is two triangles where all goes evenly over it, and cut finely where not") {
  const auto triangles = [](const std::string& last, const std::string& more = "") {
    return load_pbrt_world("Shape \"bilinearmesh\" \"point3 P\" [ 0 0 0  1 0 0  0 1 0  " + last + " ]" + more)
        .scene.geometry->triangle_count();
  };
  CHECK(triangles("1 1 0") == 2);
  CHECK(triangles("1 1 1") == 512);
  CHECK(triangles("0.5 1 0") == 512);
  CHECK(triangles("1 1 0", " \"point2 uv\" [ 0 0  2 0  0 1  2 1 ]") == 2);
  CHECK(triangles("1 1 0", " \"point2 uv\" [ 0 0  2 0  0 1  1 1 ]") == 512);
  CHECK(triangles("1 1 0", " \"normal N\" [ 0 0 1  1 0 1  0 0 1  1 0 1 ]") == 2);
  CHECK(triangles("1 1 0", " \"normal N\" [ 0 0 1  1 0 1  0 0 1  0 1 1 ]") == 512);
  CHECK(near(front(load_pbrt_world("Shape \"bilinearmesh\" \"point3 P\" [ 0 0 0  1 0 0  0 1 0  1 1 0 ]")),
             {0, 0, 1}));
}

TEST_CASE("wrong indices and lengths of a mesh are named") {
  const std::string points = "WorldBegin Shape \"trianglemesh\" \"point3 P\" [ 0 0 0  1 0 0  0 1 0  1 1 0 ]";
  CHECK(message_of(points).find("this shape of 4 positions needs \"integer indices\", 3 a face") !=
        std::string::npos);
  CHECK(message_of(points + " \"integer indices\" [ 0 1 4 ]")
            .find("the index 4 (number 3) is out of range; valid are 0 to 3") != std::string::npos);
  CHECK(message_of(points + " \"integer indices\" [ 0 1 -1 ]")
            .find("the index -1 (number 3) is out of range; valid are 0 to 3") != std::string::npos);
  CHECK(message_of(points + " \"integer indices\" [ 0 1 ]").find("2 indices are not 3 a face") !=
        std::string::npos);
  CHECK(message_of("WorldBegin Shape \"trianglemesh\"").find("this shape needs its positions") !=
        std::string::npos);
  CHECK(message_of("WorldBegin Translate 1e13 0 0 " + pbrt_triangle)
            .find("a coordinate of this shape lies beyond +-1e+12") != std::string::npos);
}

}  // namespace twinray
