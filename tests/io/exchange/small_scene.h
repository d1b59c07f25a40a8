// SPDX-License-Identifier: Apache-2.0
// An exchange form to put faults into.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "core/error.h"
#include "io/exchange/reader.h"
#include "io/exchange/writer.h"
#include "tests/support/json.h"

namespace twinray::test {

/// The error that a text gives.
inline std::string error_of(const nlohmann::json& json) {
  try {
    read_exchange(json.dump(), "a.json", {}, [](const std::string& path) -> std::string {
      throw Error(path + ": there is no such file");
    });
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

/// A scene without files.
inline nlohmann::json small() {
  Scene scene;
  scene.materials = {{"grey", Lambert{}}, {"metal", Conductor{}}};
  scene.geometry = std::make_shared<const Geometry>(std::vector<Shape>{SphereSet{"ball", {{{0, 0, 0}, 1}}}});
  scene.bindings = {{.material = 1, .light = 0}};
  scene.lights = {{"lamp", SphereLight{0, {1, 1, 1}}}, {"spot", SpotLight{}}};
  return nlohmann::json::parse(exchange_json(scene, "a.json", ExchangePicture{480, 360}));
}

}  // namespace twinray::test
