// SPDX-License-Identifier: Apache-2.0
// Thin films in exchange form, whose files did not always know them.
#include "core/error.h"
#include "core/geometry.h"
#include "io/exchange/writer.h"
#include "io/scene_file.h"
#include "tests/support/catch.h"
#include "tests/support/json.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {
namespace {

/// A scene of nothing but a surface with a film.
nlohmann::json film_json() {
  Scene scene;
  scene.geometry = std::make_shared<const Geometry>(std::vector<Shape>{});
  scene.materials = {{"oil", Principled{.thin_film_weight = 0.5f, .thin_film_thickness = 2}}};
  return nlohmann::json::parse(exchange_json(scene, "a.json", {48, 36}));
}

Principled film_of(const nlohmann::json& json) {
  const TemporaryFolder folder;
  write_text(folder.file("a.json"), json.dump());
  return std::get<Principled>(load_scene(folder.file("a.json")).scene.materials.at(0).model);
}

std::string film_error(const nlohmann::json& json) {
  try {
    film_of(json);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("exchange: surfaces of files that know no films have none") {
  nlohmann::json json = film_json();
  CHECK(film_of(json).thin_film_weight == 0.5f);
  CHECK(film_of(json).thin_film_thickness == 2);
  for (const char* key : {"thin_film_weight", "thin_film_thickness", "thin_film_ior"})
    REQUIRE(json["materials"][0].erase(key) == 1);
  const Principled old = film_of(json);
  CHECK(old.thin_film_weight == 0);
  CHECK(old.thin_film_ior == 1.4f);
}

TEST_CASE("exchange: what a file says of its picture comes back") {
  Scene scene;
  scene.geometry = std::make_shared<const Geometry>(std::vector<Shape>{});
  const PixelFilter filter{.kind = FilterKind::mitchell, .radius = {2, 1.75f}, .sigma = 0.3f, .b = 0.1f};
  const TemporaryFolder folder;
  const auto defaults_of = [&](const nlohmann::json& json) {
    write_text(folder.file("a.json"), json.dump());
    return load_scene(folder.file("a.json")).defaults;
  };
  nlohmann::json json = nlohmann::json::parse(
      exchange_json(scene, "a.json", {48, 36, 17, 3, filter, {{4, 5, 44, 31}}, 4500.0}));
  const RenderDefaults all = defaults_of(json);
  CHECK(all.samples == 17u);
  CHECK(all.max_depth == 3);
  CHECK(all.filter == filter);
  CHECK(all.crop == std::array{4, 5, 44, 31});
  CHECK(all.daylight_kelvin == 4500.0);
  const auto error = [&](const char* key, const nlohmann::json& value) {
    nlohmann::json wrong = json;
    wrong["render"][key] = value;
    try {
      defaults_of(wrong);
    } catch (const Error& fault) {
      return std::string(fault.what());
    }
    return std::string();
  };
  CHECK(error("samples", 0).find("render: \"samples\" is 0") != std::string::npos);
  CHECK(error("max_depth", 101).find("render: \"max_depth\" is 101") != std::string::npos);
  CHECK(error("daylight_kelvin", 1999).find("render: \"daylight_kelvin\" is 1999; valid are 2000 to 25000") !=
        std::string::npos);
  for (const std::array<int, 4>& outside : {std::array{5, 5, 44, 31}, {4, 6, 44, 31}})
    CHECK(error("crop", outside).find("render: \"crop\" is not a part of 48 x 36 pixels") !=
          std::string::npos);
  CHECK(error("crop", {0, 0, 0, 1}).find("render: \"crop\"") != std::string::npos);
  nlohmann::json wide = json["render"]["filter"];
  wide["radius"] = {20, 1};
  CHECK(error("filter", wide).find("render.filter: ") != std::string::npos);
  wide["type"] = "sinc";
  CHECK(error("filter", wide).find("valid are box, triangle, gaussian") != std::string::npos);
  const RenderDefaults none = defaults_of(nlohmann::json::parse(exchange_json(scene, "a.json", {48, 36})));
  CHECK_FALSE(none.samples);
  CHECK_FALSE(none.max_depth);
  CHECK_FALSE(none.filter);
  CHECK_FALSE(none.crop);
  CHECK_FALSE(none.daylight_kelvin);
}

TEST_CASE("exchange: films have thicknesses and indices that all formats can say") {
  const auto with = [](const char* key, float value) {
    nlohmann::json json = film_json();
    json["materials"][0][key] = value;
    return film_error(json);
  };
  CHECK(with("thin_film_thickness", 1000) == "");
  CHECK(with("thin_film_thickness", 1001).ends_with("it must be from 0 to 1000 micrometers"));
  CHECK(with("thin_film_thickness", -1).ends_with("it must be from 0 to 1000 micrometers"));
  CHECK(with("thin_film_ior", 0.5f).ends_with("it must be from 1 to 100"));
  CHECK(with("thin_film_ior", 101).ends_with("it must be from 1 to 100"));
  CHECK(with("thin_film_weight", 2).ends_with("it must be from 0 to 1"));
}

}  // namespace twinray::test
