// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/writer_media.h"

#include "tests/support/catch.h"
#include "tests/support/text.h"

namespace twinray::test {
namespace {

const std::vector<std::string> body_names{"haze", "jade", "cabin", "glass", "air"};

/// Balls around the origin, the first one of haze, with others of jade, nothing and glass within it.
Scene balls_in_haze() {
  Scene scene;
  scene.materials = {{"haze", Interface{}, {}, {.scattering = {1, 1, 1}}},
                     {"jade", Dielectric{}, {}, {.absorption = {1, 0, 1}, .scattering = {4, 4, 4}}},
                     {"cabin", Interface{}, {}, {.is_clear = true}},
                     {"glass", Dielectric{}},
                     {"air", Interface{}, {}, {.absorption = {0.5f, 0.5f, 0.5f}}}};
  scene.geometry = std::make_shared<const Geometry>(
      std::vector<Shape>{SphereSet{"", {{{0, 0, 0}, 9}}}, SphereSet{"", {{{0, 0, 0}, 1}}},
                         SphereSet{"", {{{4, 0, 0}, 1}}}, SphereSet{"", {{{-4, 0, 0}, 1}}}});
  scene.bindings = {{0}, {1}, {2}, {3}};
  return scene;
}

std::string interface_text(const std::string& inside, const std::string& outside) {
  return "MediumInterface \"" + inside + "\" \"" + outside + "\"\n";
}

}  // namespace

TEST_CASE("written pbrt: each body says what it lies in, and the camera what it stands in") {
  Scene scene = balls_in_haze();
  scene.camera.position = {0, 3, 0};
  Losses losses;
  const PbrtMediaWriter in_haze(scene, body_names, losses);
  CHECK(in_haze.interface_of(0) == interface_text("within haze", ""));
  CHECK(in_haze.interface_of(1) == interface_text("within jade", "within haze"));
  CHECK(in_haze.interface_of(2) == interface_text("", "within haze"));
  CHECK(in_haze.interface_of(3).empty());  // What is around it goes on within it.
  CHECK(contains(in_haze.view(), "MakeNamedMedium \"within haze\""));
  CHECK(in_haze.view().ends_with(interface_text("", "within haze")));
  CHECK(contains(in_haze.world(), "MakeNamedMedium \"within jade\""));
  CHECK_FALSE(contains(in_haze.world(), "MakeNamedMedium \"within haze\""));
  CHECK(in_haze.world().ends_with(interface_text("", "")));
  // In a clear body, and outside of all.
  for (const Vec3& place : {Vec3{4, 0, 0}, Vec3{0, 0, 20}}) {
    scene.camera.position = place;
    const PbrtMediaWriter clear(scene, body_names, losses);
    CHECK(clear.view().empty());
    CHECK_FALSE(contains(clear.world(), "MediumInterface"));
  }
}

TEST_CASE("written pbrt: an atmosphere is outside of all that is in nothing else") {
  Scene scene = balls_in_haze();
  scene.camera.position = {0, 0, 20};
  scene.atmosphere = 4;
  Losses losses;
  const PbrtMediaWriter media(scene, body_names, losses);
  CHECK(media.interface_of(0) == interface_text("within haze", "around all shapes"));
  CHECK(media.interface_of(1) == interface_text("within jade", "within haze"));
  CHECK(contains(media.view(), "MakeNamedMedium \"around all shapes\""));
  CHECK(media.view().ends_with(interface_text("", "around all shapes")));
  CHECK(media.world().ends_with(interface_text("around all shapes", "around all shapes")));
  CHECK(losses.lines("a.pbrt").empty());
}

}  // namespace twinray::test
