// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/lens_file.h"

#include <algorithm>
#include <cmath>

#include "tests/support/catch.h"
#include "tests/support/pbrt_text.h"
#include "tests/support/round_trip.h"
#include "tests/support/text.h"

namespace twinray::test {
namespace {

const std::string glass =
    "# radius, thickness, index, diameter\n"
    "50 5 1.5 20  -50 1 1 20 # both sides\n 0 40 0 12";

const PbrtTexts files{{"lens.dat", glass},
                      {"odd.dat", "50 5 1.5 20 -50"},
                      {"words.dat", "50 5 glass 20"},
                      {"none.dat", "# nothing\n"},
                      {"hollow.dat", "-50 5 1.5 20 50 40 1 20"},
                      {"flat.dat", "50 5 1.5 20 0 40 1 20"},
                      {"open.dat", "50 5 1.5 20 -50 40 1 20"},
                      {"water.dat", "50 5 1.5 20 -50 40 1.33 20"}};

LoadedScene load_camera(const std::string& parameters, const std::string& before = "",
                        const std::string& film = "") {
  return load_pbrt_text("Film \"rgb\" \"integer xresolution\" 300 \"integer yresolution\" 200 " + film +
                            "\n" + before + "\nCamera \"realistic\" " + parameters + "\nWorldBegin\n" +
                            pbrt_triangle,
                        {}, files);
}

std::string lens_error(const std::string& parameters) {
  return error_text([&] { load_camera(parameters); });
}

bool has_line(const std::vector<std::string>& lines, const std::string& line) {
  return std::count(lines.begin(), lines.end(), line) == 1;
}

const std::string lens_named = "\"string lensfile\" \"lens.dat\" \"float aperturediameter\" 12 ";

}  // namespace

TEST_CASE("a realistic camera has the lens of its file in scene units, focused") {
  const LoadedScene loaded = load_camera(lens_named + "\"float focusdistance\" 2");
  CHECK(loaded.warnings.empty());
  CHECK(loaded.summary.camera == "realistic");
  const Camera& camera = loaded.scene.camera;
  REQUIRE(camera.lenses);
  CHECK(camera.lens_radius == 0);
  const auto& surfaces = camera.lenses->surfaces();
  REQUIRE(surfaces.size() == 3);
  CHECK(surfaces[0].curvature_radius == Approx(0.05));
  CHECK(surfaces[1].curvature_radius == Approx(-0.05));
  CHECK(surfaces[0].thickness == Approx(0.005));
  CHECK(surfaces[0].ior == 1.5);
  CHECK(surfaces[0].aperture_radius == Approx(0.01));
  CHECK(surfaces[2].aperture_radius == Approx(0.006));
  CHECK(camera.lenses->focus_distance() == Approx(2).epsilon(1e-6));
  // The film's diagonal is 35 mm by default, of 3 to 2.
  const double half_height = 0.0175 / std::sqrt(1 + 1.5 * 1.5), distance = camera.lenses->image_distance();
  CHECK(double(camera.tan_half_height) * distance == Approx(half_height));
  CHECK(double(camera.tan_half_width) * distance == Approx(1.5 * half_height));
  CHECK(camera.lenses->film_radius() == Approx(0.0175));
}

TEST_CASE("a camera that is scaled has a lens that is, too, and sees the same") {
  const Camera plain = load_camera(lens_named).scene.camera;
  const Camera scaled = load_camera(lens_named, "Scale 0.1 0.1 0.1").scene.camera;
  CHECK(scaled.lenses->surfaces()[0].curvature_radius == Approx(0.5));
  CHECK(scaled.lenses->focus_distance() == Approx(10 * plain.lenses->focus_distance()));
  CHECK(scaled.tan_half_width == Approx(plain.tan_half_width));
  const LensRay near = lens_ray(plain, {0.3f, 0.4f}, {0.5f, 0.5f}),
                far = lens_ray(scaled, {0.3f, 0.4f}, {0.5f, 0.5f});
  CHECK(near.light > 0);
  CHECK(far.light == Approx(near.light).epsilon(1e-5));
  CHECK(length(far.ray.direction - near.ray.direction) < 1e-5f);
}

TEST_CASE("the film's diagonal is that of its statement") {
  const Camera small = load_camera(lens_named, "", "\"float diagonal\" 17.5").scene.camera;
  CHECK(small.tan_half_width == Approx(load_camera(lens_named).scene.camera.tan_half_width / 2));
}

TEST_CASE("a stop is as wide as the camera says, and no wider than the file has it") {
  const auto stop = [](const std::string& parameter) {
    return load_camera("\"string lensfile\" \"lens.dat\" " + parameter)
        .scene.camera.lenses->surfaces()[2]
        .aperture_radius;
  };
  CHECK(stop("") == Approx(0.0005));  // pbrt's default is 1 mm.
  CHECK(stop("\"float aperturediameter\" 5") == Approx(0.0025));
  CHECK(stop("\"float aperturediameter\" 50") == Approx(0.006));
  const LoadedScene wide = load_camera("\"string lensfile\" \"lens.dat\" \"float aperturediameter\" 50");
  REQUIRE(wide.warnings.size() == 1);
  CHECK(
      contains(wide.warnings[0].text(), "an aperture of 50 mm is wider than this lens allows: it is 12 mm"));
}

TEST_CASE("what a realistic camera cannot be is refused with its place") {
  CHECK(contains(lens_error(""), "scene.pbrt:3:1: a realistic camera needs its lens, \"string lensfile\""));
  CHECK(contains(lens_error("\"string lensfile\" \"no.dat\""), "no.dat: there is no such file"));
  CHECK(contains(lens_error("\"string lensfile\" \"odd.dat\""),
                 "odd.dat:1:1: a lens file of 5 numbers; each surface needs four"));
  CHECK(contains(lens_error("\"string lensfile\" \"none.dat\""), "none.dat:1:1: a lens file of 0 numbers"));
  CHECK(contains(lens_error("\"string lensfile\" \"words.dat\""), "words.dat:1:6"));
  CHECK(contains(lens_error("\"string lensfile\" \"hollow.dat\""),
                 "hollow.dat:1:1: this lens brings no distant light together"));
  CHECK(
      contains(lens_error("\"string lensfile\" \"water.dat\""),
               "water.dat:1:1: surface 2 of the lens: an index of refraction of 1.33; valid is that of air"));
  CHECK(contains(lens_error(lens_named + "\"float focusdistance\" 0.1"), "; this is 100 (in millimeters)"));
  CHECK(contains(lens_error(lens_named + "\"float focusdistance\" -1"), "\"focusdistance\" is -1"));
}

TEST_CASE("a lens without a stop and flat glass are told, and so is a transform that stretches") {
  const auto warned = [](const std::string& lens, const std::string& before = "") {
    const LoadedScene loaded =
        load_camera("\"string lensfile\" \"" + lens + "\" \"float aperturediameter\" 12", before);
    std::string text;
    for (const Diagnostic& warning : loaded.warnings) text += warning.message + "\n";
    return text;
  };
  CHECK(warned("lens.dat").empty());
  CHECK(warned("lens.dat", "Scale 2 2 2").empty());
  CHECK(warned("open.dat") == "this lens has no stop: \"aperturediameter\" changes nothing\n");
  CHECK(load_camera("\"string lensfile\" \"open.dat\"").warnings.empty());
  CHECK(contains(warned("flat.dat"),
                 "surface 2 of this lens is flat and divides glass from something else: it refracts"));
  for (const char* scale : {"Scale 2 2 1", "Scale 1 1 2", "Scale 2 1 1"})
    CHECK(warned("lens.dat", scale) ==
          "the camera's transform scales its axes differently: its lens and film have the "
          "scale of the view's axis\n");
}

TEST_CASE("parameters that a realistic camera does not have are named, as are shapes of its stop") {
  const LoadedScene loaded = load_camera(lens_named + "\"float fov\" 30 \"string aperture\" \"star\"");
  REQUIRE(loaded.warnings.size() == 2);
  CHECK(
      contains(loaded.warnings[0].text(), "an aperture of the shape \"star\" is not rendered: it is round"));
  CHECK(contains(loaded.warnings[1].text(), "\"float fov\" is not known here"));
  CHECK(load_camera(lens_named + "\"string aperture\" \"circular\"").warnings.empty());
}

TEST_CASE("a lens system comes back from our JSON with all bits and from pbrt's format nearly so") {
  const Scene scene = load_camera(lens_named + "\"float focusdistance\" 2").scene;
  const RoundTrip exact = round_trip(scene, "a.json"), written = round_trip(scene, "a.pbrt");
  CHECK(exact.warnings.empty());
  CHECK(written.warnings.empty());
  REQUIRE(exact.scene.camera.lenses);
  CHECK(exact.scene.camera.lenses->surfaces() == scene.camera.lenses->surfaces());
  REQUIRE(written.scene.camera.lenses);
  const auto fitted = [](const Scene& of) { return fit_frame(of.camera, 480, 360); };
  const Camera before = fitted(scene), after = fitted(exact.scene), later = fitted(written.scene);
  for (const Vec2 frame : {Vec2{0.5f, 0.5f}, Vec2{0.1f, 0.2f}, Vec2{0.8f, 0.3f}}) {
    const LensRay a = lens_ray(before, frame, {0.4f, 0.6f}), b = lens_ray(after, frame, {0.4f, 0.6f}),
                  c = lens_ray(later, frame, {0.4f, 0.6f});
    CHECK(a.light > 0);
    CHECK(a.light == b.light);
    CHECK(a.ray.direction == b.ray.direction);
    CHECK(a.light == Approx(c.light).epsilon(1e-3));
    CHECK(length(a.ray.direction - c.ray.direction) < 1e-4f);
  }
}

TEST_CASE("a lens of other than usual sizes is written for a camera that is scaled") {
  for (const char* scale : {"Scale 1e-5 1e-5 1e-5", "Scale 1e6 1e6 1e6"}) {
    const Scene scene = load_camera(lens_named + "\"float focusdistance\" 2", scale).scene;
    const RoundTrip written = round_trip(scene, "a.pbrt");
    CHECK(written.warnings.empty());
    const LensRay a = lens_ray(fit_frame(scene.camera, 480, 360), {0.2f, 0.3f}, {0.5f, 0.5f}),
                  b = lens_ray(fit_frame(written.scene.camera, 480, 360), {0.2f, 0.3f}, {0.5f, 0.5f});
    CHECK(a.light > 0);
    CHECK(a.light == Approx(b.light).epsilon(1e-3));
    CHECK(length(a.ray.direction - b.ray.direction) < 1e-4f);
    CHECK(a.ray.t_min == Approx(b.ray.t_min).epsilon(1e-3));
  }
}

TEST_CASE("what pbrt's film cannot be is named among what is lost") {
  Scene scene = load_camera(lens_named + "\"float focusdistance\" 2").scene;
  const auto moved = [&](double thickness) {
    std::vector<LensSurface> surfaces = scene.camera.lenses->surfaces();
    surfaces.back().thickness = thickness;
    Scene other = scene;
    other.camera.lenses = std::make_shared<const LensSystem>(surfaces, 0.02);
    return round_trip(other, "a.pbrt").warnings;
  };
  const std::string loss = "the camera's film is moved, for pbrt cannot have it where it is";
  CHECK(!has_line(moved(0.06), loss));
  CHECK(has_line(moved(0.15), loss));
  CHECK(has_line(moved(0.03), loss));
  scene.camera.is_stretched = true;
  CHECK(has_line(round_trip(scene, "a.pbrt").warnings,
                 "the camera's pixels become square, for its film has no others in pbrt"));
}

TEST_CASE("a lens system that is shifted or of glTF is named among what is lost") {
  Scene scene = load_camera(lens_named + "\"float focusdistance\" 2").scene;
  CHECK(has_line(round_trip(scene, "a.gltf").warnings, "the camera's lens is a pinhole"));
  scene.camera.frame_center = {0.1f, 0};
  CHECK(has_line(round_trip(scene, "a.pbrt").warnings,
                 "the shift of the camera's frame is left out, for its lens has none in pbrt"));
}

}  // namespace twinray::test
