// SPDX-License-Identifier: Apache-2.0
// KHR_materials_iridescence.
#include "tests/io/gltf/surface.h"
#include "tests/support/catch.h"

namespace twinray::test {
namespace {

GltfFile filmed(const nlohmann::json& film) {
  return gltf_surface({{"extensions", {{"KHR_materials_iridescence", film}}}});
}
}  // namespace

TEST_CASE("gltf: iridescence is a film, as thick as its maximum without a picture") {
  const Principled usual = model_of(filmed({{"iridescenceFactor", 0.5}}));
  CHECK(usual.thin_film_weight == 0.5f);
  CHECK(usual.thin_film_ior == 1.3f);
  CHECK(usual.thin_film_thickness == Approx(0.4));
  const Principled own = model_of(filmed({{"iridescenceFactor", 1},
                                          {"iridescenceIor", 1.75},
                                          {"iridescenceThicknessMinimum", 300},
                                          {"iridescenceThicknessMaximum", 1250}}));
  CHECK(own.thin_film_ior == 1.75f);
  CHECK(own.thin_film_thickness == Approx(1.25));
  GltfFile pictured = filmed(nlohmann::json::object());
  pictured.json["materials"][0]["extensions"]["KHR_materials_iridescence"] = {
      {"iridescenceFactor", 1}, {"iridescenceThicknessTexture", {{"index", add_picture(pictured)}}}};
  CHECK(input_at(pictured.load(), MaterialInput::thin_film_thickness, left).r ==
        Approx(0.1 + 0.3 * 51 / 255));
  CHECK(model_of(filmed({{"iridescenceIor", 1.75}})).thin_film_weight == 0);
  CHECK(model_of(filmed(nlohmann::json::object())).thin_film_weight == 0);
}

TEST_CASE("gltf: pictures of a film have its weight in red, and its thickness between two in green") {
  GltfFile file = filmed(nlohmann::json::object());
  const int picture = add_picture(file);
  file.json["materials"][0]["extensions"]["KHR_materials_iridescence"] = {
      {"iridescenceFactor", 0.5},
      {"iridescenceTexture", {{"index", picture}}},
      {"iridescenceThicknessMinimum", 500},
      {"iridescenceThicknessMaximum", 300},
      {"iridescenceThicknessTexture", {{"index", picture}}}};
  const LoadedScene loaded = file.load();
  CHECK(loaded.warnings.empty());
  CHECK(input_at(loaded, MaterialInput::thin_film_weight, left).r == Approx(0.5 * 188 / 255));
  CHECK(input_at(loaded, MaterialInput::thin_film_thickness, left).r == Approx(0.5 - 0.2 * 51 / 255));
  CHECK(input_at(loaded, MaterialInput::thin_film_thickness, right).r == Approx(0.5 - 0.2 * 102 / 255));
}

TEST_CASE("gltf: a picture of a film alone says which texture coordinates count") {
  for (const char* slot : {"iridescenceTexture", "iridescenceThicknessTexture"}) {
    INFO(slot);
    GltfFile file = filmed(nlohmann::json::object());
    nlohmann::json& attributes = file.primitive()["attributes"];
    attributes["TEXCOORD_1"] = attributes["TEXCOORD_0"];
    attributes.erase("TEXCOORD_0");
    file.json["materials"][0]["extensions"]["KHR_materials_iridescence"] = {
        {"iridescenceFactor", 1}, {slot, {{"index", add_picture(file)}, {"texCoord", 1}}}};
    const LoadedScene loaded = file.load();
    CHECK(loaded.warnings.empty());
    CHECK(loaded.scene.materials[0].textures.size() == 1);
  }
}

TEST_CASE("gltf: films out of range are refused") {
  CHECK(filmed({{"iridescenceFactor", 2}})
            .error()
            .starts_with("test.gltf: /materials/0/extensions/KHR_materials_iridescence/iridescenceFactor: "));
  CHECK(filmed({{"iridescenceIor", 0.5}}).error().find("/iridescenceIor: ") != std::string::npos);
  CHECK(filmed({{"iridescenceThicknessMaximum", -1}}).error().find("/iridescenceThicknessMaximum: ") !=
        std::string::npos);
}

}  // namespace twinray::test
