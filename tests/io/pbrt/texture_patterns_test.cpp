// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <string>

#include "core/error.h"
#include "core/noise.h"
#include "core/texture.h"
#include "io/picture/image_file.h"
#include "tests/support/catch.h"
#include "tests/support/pbrt_text.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/text.h"

namespace twinray {

using test::contains;
using test::load_pbrt_world;

namespace {

/// What a diffuse surface with a texture reflects; the statements may warn as often as is said.
struct Shown {
  explicit Shown(const std::string& texture, std::size_t warnings = 0)
      : loaded(load_pbrt_world("Texture \"t\" \"spectrum\" " + texture +
                               " Material \"diffuse\" \"texture reflectance\" \"t\"")) {
    CHECK(loaded.warnings.size() == warnings);
  }
  Rgb at(const TexturePoint& point) const {
    return evaluate(loaded.scene.textures, loaded.scene.materials[1].textures.at(0).texture, point);
  }
  Rgb mean() const { return std::get<Lambert>(loaded.scene.materials[1].model).reflectance; }

  LoadedScene loaded;
};

/// The message of what these statements are refused with.
std::string error(const std::string& statements) {
  try {
    load_pbrt_world(statements);
  } catch (const Error& e) {
    return e.what();
  }
  return "";
}

/// Of a texture in the space of these statements: as a reflectance, or the roughness that is a number.
Rgb placed_at(const std::string& transform, const std::string& texture, const TexturePoint& point,
              bool is_number = false) {
  const LoadedScene loaded =
      load_pbrt_world("AttributeBegin " + transform + " Texture \"t\" \"" +
                      (is_number ? "float" : "spectrum") + "\" " + texture + " AttributeEnd Material " +
                      (is_number ? "\"conductor\" \"texture roughness\" \"t\""
                                 : "\"diffuse\" \"texture reflectance\" \"t\""));
  CHECK(loaded.warnings.empty());
  return evaluate(loaded.scene.textures, loaded.scene.materials[1].textures.at(0).texture, point);
}

}  // namespace

TEST_CASE("parameters that a mapping has not are unused") {
  const auto unused = [](const std::string& parameters) {
    std::string names;
    for (const Diagnostic& warning : load_pbrt_world("Texture \"t\" \"float\" " + parameters).warnings)
      names += warning.message.substr(0, warning.message.find(" is")) + " ";
    return names;
  };
  const std::string all =
      " \"float uscale\" 2 \"float vscale\" 2 \"float udelta\" 2 \"vector3 v1\" [ 1 0 0 ]";
  CHECK(unused("\"dots\"" + all) == "\"vector3 v1\" ");
  CHECK(unused("\"dots\" \"string mapping\" \"planar\"" + all) == "\"float uscale\" \"float vscale\" ");
  CHECK(unused("\"dots\" \"string mapping\" \"cylindrical\"" + all) ==
        "\"float uscale\" \"float vscale\" \"float udelta\" \"vector3 v1\" ");
  CHECK(unused("\"checkerboard\" \"integer dimension\" 3 \"float uscale\" 2") == "\"float uscale\" ");
}

TEST_CASE("corners are mixed over the unit square, and dots lie on another texture") {
  const Shown square(
      "\"bilerp\" \"rgb v00\" [ .1 .1 .1 ] \"rgb v01\" [ .2 .2 .2 ] \"rgb v10\" [ .3 .3 .3 ] \"rgb v11\" [ "
      ".4 .4 0 ] \"float uscale\" 2");
  CHECK(square.at({}).r == Approx(0.1));
  CHECK(square.at({.uv = {0, 1}}).r == Approx(0.2));
  CHECK(square.at({.uv = {0.5f, 0}}).r == Approx(0.3));
  CHECK(square.at({.uv = {0.5f, 1}}).b == 0);
  CHECK(square.mean().r == Approx(0.25));
  CHECK(square.mean().b == Approx(0.15));
  const Shown usual("\"bilerp\"");
  CHECK(usual.at({.uv = {0.3f, 0.75f}}).g == Approx(0.75));
  const Shown dots(
      "\"dots\" \"rgb outside\" [ .2 .3 .4 ] \"rgb inside\" [ .5 .6 .7 ] \"float uscale\" 3 \"float udelta\" "
      ".5");
  for (int i = 0; i < 100; ++i) {
    const Vec2 uv{float(i % 10) * 0.31f, float(i / 10) * 0.57f};
    const bool is_dot = is_in_dot({3 * uv.x + 0.5f, uv.y});  // pbrt's dots have what is called outside.
    CHECK(dots.at({.uv = uv}) == (is_dot ? Rgb{0.2f, 0.3f, 0.4f} : Rgb{0.5f, 0.6f, 0.7f}));
  }
  CHECK(Shown("\"dots\"").mean().r == Approx(1 - 25832.0 / 65536 * 3.14159265 * 0.35 * 0.35));
}

TEST_CASE("a mix by direction turns with its transform, and goes by the normal of the geometry") {
  const auto at = [](const std::string& transform, const std::string& direction, const Vec3& normal) {
    return placed_at(transform, "\"directionmix\" \"float tex1\" 1 \"rgb tex2\" [ 0 .5 0 ]" + direction,
                     {.normal = normal})
        .r;
  };
  CHECK(at("", "", {0, 1, 0}) == 1);
  CHECK(at("", "", {0, 0.6f, -0.8f}) == Approx(0.6));
  CHECK(at("Rotate 90 1 0 0 Scale 7 7 7", "", {0, 0.6f, -0.8f}) == Approx(0.8));
  CHECK(at("Translate 1 2 3", " \"vector3 dir\" [ 3 0 4 ]", {1, 0, 0}) == Approx(0.6));
  CHECK(contains(error("Texture \"t\" \"float\" \"directionmix\" \"vector3 dir\" [ 0 0 0 ]"),
                 "the \"dir\" of a directionmix is no direction here"));
}

TEST_CASE("patterns in space lie where their transform puts them") {
  const std::string there = "Translate 1 2 3 Scale 2 2 2 Rotate 90 0 0 1";
  const auto own = [](const Vec3& p) { return Vec3{(p.y - 2) / 2, -(p.x - 1) / 2, (p.z - 3) / 2}; };
  for (const Vec3 p : {Vec3{0.3f, 0.7f, 0.2f}, Vec3{5.3f, -2.1f, 7.7f}, Vec3{-1.9f, 3.3f, 4.1f}}) {
    const TexturePoint at{.position = p, .width = 0.1f};
    const Vec3 q = own(p);
    CHECK(placed_at(there, "\"fbm\" \"integer octaves\" 3 \"float roughness\" .7", at, true).r ==
          Approx(fbm(q, 0.05f, {3, 0.7f})).margin(1e-5));
    CHECK(placed_at(there, "\"wrinkled\"", at, true).r == Approx(turbulence(q, 0.05f, {})).margin(1e-5));
    const float waves = std::fabs(fbm(q * 0.1f, 0.005f, {3})) * fbm(q, 0.05f, {6});
    CHECK(placed_at(there, "\"windy\"", at, true).r == Approx(waves).margin(1e-5));
    const float phase = 4 * q.y + 0.5f * fbm(q * 4, 0.2f, {});
    CHECK(placed_at(there, "\"marble\" \"float scale\" 4 \"float variation\" .5", at).b ==
          Approx(marble_color(phase).b).margin(1e-4));
    const bool is_even = int(std::floor(q.x) + std::floor(q.y) + std::floor(q.z)) % 2 == 0;
    CHECK(placed_at(there, "\"checkerboard\" \"integer dimension\" 3 \"float tex2\" .25", at).r ==
          (is_even ? 1 : 0.25f));
    CHECK(placed_at("", "\"checkerboard\" \"integer dimension\" 3", {.position = q}).r == (is_even ? 1 : 0));
  }
  CHECK(Shown("\"fbm\"", 1).loaded.warnings[0].message ==
        "fbm is a texture of type float in pbrt, which fails here");
  const LoadedScene marble = load_pbrt_world("Texture \"t\" \"float\" \"marble\"");
  REQUIRE(marble.warnings.size() == 1);
  CHECK(marble.warnings[0].message == "marble is a texture of type spectrum in pbrt, which fails here");
}

TEST_CASE("a pattern in the plane is placed by its mapping") {
  const auto at = [](const std::string& words, const Vec3& p) {
    return placed_at("Translate 0 0 5",
                     "\"bilerp\" \"float v10\" 1 \"float v01\" 10 \"float v11\" 11 " + words,
                     {.uv = {9, 9}, .position = p})
        .r;
  };
  CHECK(at("\"string mapping\" \"planar\"", {0.25f, 0.5f, 7}) == Approx(0.25 + 5));
  CHECK(
      at("\"string mapping\" \"planar\" \"vector3 v1\" [ 0 0 2 ] \"vector3 v2\" [ .5 0 0 ] \"float udelta\" "
         ".125 \"float vdelta\" .75",
         {0.5f, 9, 5.25f}) == Approx(0.625 + 10));
  CHECK(at("\"string mapping\" \"spherical\"", {0, 2, 5}) == Approx(0.5 + 10 * 0.25));
  CHECK(at("\"string mapping\" \"cylindrical\"", {2, 0, 4.5f}) == Approx(0.5 - 10 * 0.5));
  // Of boards and dots only which of two it is goes by the mapping; these lie by themselves.
  const auto board = [](Vec2 uv, const Vec3& p) {
    return placed_at("Texture \"ramp\" \"spectrum\" \"bilerp\"",
                     "\"checkerboard\" \"texture tex1\" \"ramp\" \"string mapping\" \"planar\"",
                     {.uv = uv, .position = p})
        .r;
  };
  CHECK(board({0, 0.75f}, {0.5f, 0.5f, 0}) == 0.75f);
  CHECK(board({0, 0.75f}, {1.5f, 0.5f, 0}) == 0);
  const test::TemporaryFolder folder;
  Image pixels(2, 1);
  pixels.at(0, 0) = {1, 0, 0};
  write_exr(folder.file("red.exr"), pixels);
  const std::string file = folder.file("scene.pbrt");
  test::write_text(file,
                   "WorldBegin Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"red.exr\" "
                   "\"string mapping\" \"planar\" "
                   "\"string filter\" \"point\" Material \"diffuse\" \"texture reflectance\" \"t\"");
  const LoadedScene picture = load_pbrt(file);
  const std::uint32_t texture = picture.scene.materials[1].textures.at(0).texture;
  CHECK(evaluate(picture.scene.textures, texture, {.position = {0.25f, 0, 0}}).r == 1);
  CHECK(evaluate(picture.scene.textures, texture, {.position = {0.75f, 0, 0}}).r == 0);
  CHECK(std::get<Lambert>(picture.scene.materials[1].model).reflectance.r == 0.5f);
}

TEST_CASE("what is wrong with a texture that is placed is said at its statement") {
  CHECK(contains(error("Texture \"t\" \"float\" \"dots\" \"string mapping\" \"cubic\""),
                 "there is no mapping \"cubic\"; valid are uv, planar, spherical or cylindrical"));
  for (const char* statement : {"Scale 1e-20 1 1 Texture \"t\" \"float\" \"dots\" \"string mapping\" "
                                "\"planar\" \"vector3 v1\" [ 1e30 0 0 ]",
                                "Scale 1e-39 1 1 Texture \"t\" \"float\" \"fbm\""})
    CHECK(contains(error(statement), "the coordinates of this texture are too large for single precision"));
  for (const char* octaves : {"65", "-1"})
    CHECK(contains(error(std::string("Texture \"t\" \"float\" \"fbm\" \"integer octaves\" ") + octaves),
                   "it must lie in [0, 64]"));
}

}  // namespace twinray
