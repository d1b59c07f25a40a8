// SPDX-License-Identifier: Apache-2.0
// Keys that mean nothing, at each level of the exchange form.
#include "core/error.h"
#include "core/geometry.h"
#include "io/exchange/reader.h"
#include "io/exchange/writer.h"
#include "tests/support/catch.h"
#include "tests/support/json.h"

namespace twinray::test {
namespace {

/// A scene that has each kind of object.
nlohmann::json known_keys() {
  Scene scene;
  scene.materials = {{"glass", Dielectric{}}};
  scene.materials[0].interior = {.absorption = {1, 2, 3}};
  scene.geometry = std::make_shared<const Geometry>(std::vector<Shape>{SphereSet{"ball", {{{0, 0, 0}, 1}}}});
  scene.bindings = {{.material = 0}};
  scene.lights = {{"spot", SpotLight{}}};
  scene.camera.aperture_blades = 6;
  return nlohmann::json::parse(exchange_json(scene, "a.json", {48, 36}));
}

LoadedScene loaded(const nlohmann::json& json, const LoadOptions& options = {}) {
  return read_exchange(json.dump(), "a.json", options, {});
}

/// The warnings of a file that has one more key.
std::vector<std::string> warnings_with(const char* pointer) {
  nlohmann::json json = known_keys();
  json[nlohmann::json::json_pointer(pointer)] = 1;
  std::vector<std::string> texts;
  for (const Diagnostic& warning : loaded(json).warnings) texts.push_back(warning.text());
  return texts;
}

}  // namespace

TEST_CASE("a key of an exchange form that means nothing is named, with the one that it may stand for") {
  using Texts = std::vector<std::string>;
  CHECK(loaded(known_keys()).warnings.empty());
  CHECK(warnings_with("/light") ==
        Texts{"a.json: the key \"light\" means nothing here; is \"lights\" meant?"});
  CHECK(
      warnings_with("/materials/0/transmitance") ==
      Texts{
          "a.json: materials[0]: the key \"transmitance\" means nothing here; is \"transmittance\" meant?"});
  CHECK(warnings_with("/materials/0/k") == Texts{"a.json: materials[0]: the key \"k\" means nothing here"});
  CHECK(warnings_with("/materials/0/interior/thickness").size() == 1);
  CHECK(warnings_with("/lights/0/radiance").size() == 1);
  CHECK(warnings_with("/lights/0/attenuation/cubic").size() == 1);
  CHECK(warnings_with("/shapes/0/file").size() == 1);
  CHECK(warnings_with("/camera/half_width").size() == 1);
  CHECK(warnings_with("/camera/aperture/ratio") ==
        Texts{"a.json: camera: aperture: the key \"ratio\" means nothing here"});
}

TEST_CASE("keys of an exchange form that begin with an underscore are remarks") {
  CHECK(warnings_with("/_made_by").empty());
  CHECK(warnings_with("/lights/0/_").empty());
}

TEST_CASE("a strict reader refuses keys that mean nothing") {
  nlohmann::json json = known_keys();
  json["sensor"] = {};
  LoadOptions options;
  options.strict = true;
  CHECK_THROWS_WITH(loaded(json, options), "a.json: the key \"sensor\" means nothing here");
}

TEST_CASE("lights are known to a reader that leaves them out") {
  LoadOptions options;
  options.surfaces_only = true;
  CHECK(loaded(known_keys(), options).warnings.empty());
}

}  // namespace twinray::test
