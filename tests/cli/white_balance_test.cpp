// SPDX-License-Identifier: Apache-2.0
// The white that a scene's file asks for, in whatever is made of the scene.
#include "io/picture/image_file.h"
#include "tests/support/film_commands.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {

TEST_CASE("the daylight that a scene's film names is white in its pictures, and in those of its films") {
  const TemporaryFolder folder;
  const std::string world =
      "LookAt 0 0 5 0 0 0 0 1 0 Camera \"perspective\" WorldBegin LightSource \"infinite\" \"rgb L\" [.5 .4 "
      ".3] "
      "Shape \"sphere\"";
  const auto path = [&](const std::string& name) { return quoted(folder.file(name)); };
  write_text(folder.file("warm.pbrt"), "Film \"rgb\" \"float whitebalance\" 4500 " + world);
  write_text(folder.file("plain.pbrt"), "Film \"rgb\" " + world);
  const auto render = [&](const std::string& scene, const std::string& options) {
    run_well("render " + path(scene + ".pbrt") + " -q -s 2 -r 16 12 " + options);
  };
  const auto pixels = [&](const char* name) { return read_image(folder.file(name)).pixels; };
  render("warm", "-o " + path("warm.png"));
  render("plain", "-o " + path("plain.png"));
  CHECK(pixels("warm.png") != pixels("plain.png"));
  CHECK(pixels("warm.png").front().b > 1.2f * pixels("plain.png").front().b);
  render("warm", "--sample-range=0:1 --of=2 -o " + path("a.film"));
  render("warm", "--sample-range=1:2 --of=2 -o " + path("b.film"));
  run_well("merge -q " + path("a.film") + " " + path("b.film") + " -o " + path("merged.png"));
  CHECK(pixels("merged.png") == pixels("warm.png"));
  run_well("verify -q " + path("warm.png"));
  // Another white may be asked for, and floats keep the light.
  render("warm", "--white-balance=9000 -o " + path("asked.png"));
  render("plain", "--white-balance=9000 -o " + path("other.png"));
  CHECK(pixels("asked.png") == pixels("other.png"));
  render("warm", "-o " + path("warm.pfm"));
  render("plain", "-o " + path("plain.pfm"));
  CHECK(pixels("warm.pfm") == pixels("plain.pfm"));
}

}  // namespace twinray::test
