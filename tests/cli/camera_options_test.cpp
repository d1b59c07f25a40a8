// SPDX-License-Identifier: Apache-2.0
// Options of the camera and of pixels: how their words are read, and what they make of a camera.
#include <cmath>

#include "cli/camera_changes.h"
#include "cli/options/render.h"
#include "cli/render_command_line.h"
#include "core/error.h"
#include "tests/support/arguments.h"
#include "tests/support/catch.h"
#include "tests/support/lens.h"

namespace twinray::test {
namespace {

/// Looks along -z at a box in 9 to 11 in front of it.
const Camera ahead{.tan_half_width = 0.5f, .tan_half_height = 0.25f};
const Aabb box_ahead{{-1, -1, -11}, {1, 1, -9}};

std::string error_of(const CameraChanges& changes, const Camera& camera) {
  try {
    changed(camera, changes, camera);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace

TEST_CASE("a camera's name has no effect beside a file that is the camera") {
  CHECK(no_effect({"-c", "cam.info", "--camera-name=top"}) ==
        "--camera-name: no effect, for --camera's file is the camera");
  CHECK(no_effect({"--camera-name=top"}).empty());
  CHECK(no_effect({"-c", "cam.info", "--camera-name=?"}).empty());
}

TEST_CASE("a pixel filter is a name, and a radius that has a default") {
  CHECK(parse({}).render.filter == usual_filter(FilterKind::blackman_harris));
  CHECK(parse({"--filter=mitchell"}).render.filter == usual_filter(FilterKind::mitchell));
  CHECK(parse({"--filter", "blackman-harris"}).render.filter.radius == Vec2{1.5f, 1.5f});
  const PixelFilter gaussian = parse({"--filter=gaussian:3"}).render.filter;
  CHECK(gaussian.radius == Vec2{3, 3});
  CHECK(gaussian.sigma == 1);
  CHECK(message_of({"--filter=sinc"}) ==
        "--filter: there is no \"sinc\"; valid are box, triangle, gaussian, blackman-harris, mitchell");
  CHECK(message_of({"--filter=box:0.01"}) == "--filter: \"0.01\" is not a number from 0.1 to 16");
  CHECK(message_of({"--filter=box:"}) == "--filter: \"\" is not a number from 0.1 to 16");
}

TEST_CASE("a scene file's filter holds where no option names another") {
  RenderDefaults defaults;
  defaults.filter = filter_of_radius(FilterKind::triangle, 2);
  RenderArguments plain = parse({}), given = parse({"--filter=box"});
  take_defaults(defaults, plain);
  take_defaults(defaults, given);
  CHECK(plain.render.filter == *defaults.filter);
  CHECK(given.render.filter == PixelFilter{});
}

TEST_CASE("display options go with pictures of 8 bits, and a view with a configuration") {
  CHECK(parse({"--exposure=-1.5"}).display.exposure_stops == -1.5);
  CHECK(parse({"--white-balance=3200"}).display.white_kelvin == 3200.0);
  CHECK(parse({"--tone=agx"}).display.tone == Tone::agx);
  CHECK(message_of({"--white-balance=1000"}) ==
        "--white-balance: \"1000\" is not a number from 2000 to 25000");
  CHECK(message_of({"--ocio-display=screen"}) == "--ocio-display goes with --ocio-view");
  CHECK(message_of({"--ocio-view=Film", "--tone=agx"}) == "--tone and --ocio-view exclude each other");
  CHECK(message_of({"--ocio-view=Film"}) ==
        "--ocio-view: the environment variable OCIO names no configuration of OpenColorIO");
  CHECK(parse({"--tone=agx", "-o", "a.jpg"}).without_effect.empty());
  CHECK(parse({"--tone=agx", "--exposure=1", "-o", "a.exr"}).without_effect ==
        std::vector<std::string>{"--exposure: no effect, for a.exr keeps the scene's light",
                                 "--tone: no effect, for a.exr keeps the scene's light"});
}

TEST_CASE("clip planes are the file's, none, or two depths") {
  CHECK_FALSE(parse({}).load.clip_as_file);
  CHECK(parse({"--clip=file"}).load.clip_as_file);
  CHECK_FALSE(parse({"--clip=file", "--clip=none"}).load.clip_as_file);
  const ClipPlanes planes = *parse({"--clip=file", "--clip=1.5,20"}).changes.clip;
  CHECK(planes.near == 1.5f);
  CHECK(planes.far == 20);
  CHECK_FALSE(parse({"--clip=1,2", "--clip=none"}).changes.clip);
  CHECK(message_of({"--clip=all"}) == "--clip: there is no \"all\"; valid are none, file, NEAR,FAR");
  CHECK(message_of({"--clip=3,3"}) == "--clip: 3 is not less than 3");
  CHECK(message_of({"--clip=3,"}) == "--clip: \"3,\" is not two numbers A,B");
  const Camera clipped = changed(ahead, {.clip = ClipPlanes{2, 9}}, ahead);
  CHECK(camera_ray(clipped, {0, 0}, {}).t_min == 2);
  CHECK(camera_ray(clipped, {0, 0}, {}).t_max == 9);
}

TEST_CASE("projections are names, some of them with a number") {
  const auto asked = [](const char* word) { return *parse({"--projection", word}).changes.projection; };
  CHECK(asked("latitude-longitude").projection == Projection::latitude_longitude);
  CHECK(asked("equal-area").projection == Projection::equal_area);
  CHECK_FALSE(asked("fisheye").size);
  CHECK(asked("fisheye:220").size == 220.0f);
  CHECK(asked("perspective:40").size == 40.0f);
  CHECK(message_of({"--projection=round"}) ==
        "--projection: there is no \"round\"; valid are perspective:DEGREES, orthographic, "
        "orthographic:HEIGHT, latitude-longitude, fisheye, fisheye:DEGREES, equal-area");
  CHECK(message_of({"--projection=perspective"}) ==
        "--projection: perspective needs the degrees of its height, as in perspective:40");
  CHECK(message_of({"--projection=equal-area:3"}) == "--projection: equal-area takes no number");
  CHECK(message_of({"--projection=fisheye:361"}) ==
        "--projection: \"361\" is not a number from 0.001 to 360");
}

TEST_CASE("a camera gets another projection where it stands") {
  const Camera wide = with_projection(ahead, {Projection::perspective, 90}, box_ahead, 2);
  CHECK(wide.tan_half_height == Approx(1));
  CHECK(wide.tan_half_width == Approx(2));
  const Camera flat = with_projection(ahead, {Projection::orthographic, {}}, box_ahead, 2);
  CHECK(flat.projection == Projection::orthographic);
  CHECK(flat.tan_half_width == Approx(5));  // What it saw at the depth 10.
  CHECK(flat.tan_half_height == Approx(2.5));
  CHECK(with_projection(ahead, {Projection::orthographic, 8}, box_ahead, 1.5).tan_half_width == Approx(6));
  const Camera eye = with_projection(ahead, {Projection::fisheye, {}}, box_ahead, 2);
  CHECK(eye.tan_half_height == Approx(M_PI / 2));
  CHECK_THROWS_AS(with_projection(ahead, {Projection::orthographic, {}}, {{0, 0, 1}, {1, 1, 2}}, 1),
                  UsageError);
}

TEST_CASE("a frame that lies aside stays as many of its parts aside, in scene units, too") {
  Camera aside = ahead;  // Of a frame as wide as 1 and as high as 0.5 at the distance 1.
  aside.frame_center = {0.5f, -0.125f};
  const Camera flat = with_projection(aside, {Projection::orthographic, 8}, box_ahead, 2);
  CHECK(flat.frame_center == Vec2{8, -2});
  CHECK(with_projection(flat, {Projection::perspective, 90}, box_ahead, 2).frame_center.x == Approx(2));
  // In the same units it stays where it is.
  CHECK(with_projection(flat, {Projection::orthographic, 16}, box_ahead, 2).frame_center == Vec2{8, -2});
  CHECK(with_projection(aside, {Projection::perspective, 90}, box_ahead, 2).frame_center ==
        aside.frame_center);
  // A frame of which the picture's shape shows more is that much wider.
  CHECK(with_projection(aside, {Projection::orthographic, 8}, box_ahead, 4).frame_center == Vec2{8, -2});
}

TEST_CASE("a lens, its blades and its shift are those of the words") {
  const CameraChanges changes =
      parse({"--lens=0.25,7", "--aperture-blades=6:-90", "--lens-shift=0.5,-0.25"}).changes;
  const Camera camera = changed(ahead, changes, ahead);
  CHECK(camera.lens_radius == 0.25f);
  CHECK(camera.focal_distance == 7);
  CHECK(camera.aperture_blades == 6);
  CHECK(camera.aperture_turns == 0.75f);
  CHECK(camera.frame_center == Vec2{0.5f, -0.125f});  // The frame is 1 wide and 0.5 high.
  CHECK(message_of({"--lens=0.1"}) == "--lens: \"0.1\" is not two numbers A,B");
  CHECK(message_of({"--lens=0.1,0"}) == "--lens: what is in focus must lie at a distance of more than 0");
  CHECK(message_of({"--aperture-blades=2"}) == "--aperture-blades: \"2\" is not a whole number from 3 to 64");
  CHECK(message_of({"--lens-shift=1"}) == "--lens-shift: \"1\" is not two numbers A,B");
}

TEST_CASE("a lens or a projection replaces a lens system, and a shift moves its film") {
  const Camera camera = camera_with_lens_system();
  CameraChanges changes;
  changes.shift = Vec2{0.25f, 0};
  CHECK(changed(camera, changes, camera).lenses == camera.lenses);
  CHECK(changed(camera, changes, camera).frame_center.x == Approx(0.5f * camera.tan_half_width));
  changes.lens = Lens{0, 1};
  CHECK(changed(camera, changes, camera).lenses == nullptr);
  for (const AskedProjection& asked :
       {AskedProjection{Projection::perspective, 40.0f}, AskedProjection{Projection::orthographic, 2.0f},
        AskedProjection{Projection::fisheye, {}}})
    CHECK(with_projection(camera, asked, box_ahead, 1).lenses == nullptr);
}

TEST_CASE("a panorama has no lens to change") {
  const Camera around = with_panorama(ahead, Projection::latitude_longitude, 0);
  CHECK(error_of({.lens = Lens{0.1f, 1}}, around) ==
        "--lens goes with perspective and orthographic cameras; this one is latitude-longitude");
  CHECK(error_of({.shift = Vec2{1, 0}}, around) ==
        "--lens-shift goes with perspective and orthographic cameras; this one is latitude-longitude");
  CHECK(error_of({.clip = ClipPlanes{1, 2}}, around) == "accepted");
}

TEST_CASE("overscan is pixels or percent around the frame, in a format that has one") {
  const auto window = [](std::vector<std::string> words) {
    words.insert(words.end(), {"-r", "200", "101", "-o", "a.exr"});
    return *parse(words).render.window;
  };
  CHECK(window({"--overscan=12"}) == PixelRect{-12, -12, 212, 113});
  CHECK(window({"--overscan=5%"}) == PixelRect{-10, -6, 210, 107});
  CHECK(message_of({"--overscan=5"}) ==
        "--overscan: twinray.png cannot tell a frame from what is around it; an .exr can");
  CHECK(message_of({"--overscan=5", "-o", "a.exr", "-p", "0", "0", "4", "4"}) ==
        "--overscan and --crop exclude each other");
  CHECK(message_of({"--overscan=-1"}) == "--overscan: \"-1\" is not a whole number from 0 to 16384");
  CHECK(message_of({"--overscan=101%"}) == "--overscan: \"101\" is not a number from 0 to 100");
}

}  // namespace twinray::test
