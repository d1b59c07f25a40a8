// SPDX-License-Identifier: Apache-2.0
#include "io/exchange/texture.h"

#include "tests/io/exchange/small_scene.h"
#include "tests/support/catch.h"

namespace twinray::test {

TEST_CASE("what is wrong with the textures of an exchange form is said with its entry") {
  nlohmann::json right = small();
  right["version"] = 3;
  right["textures"] = {{{"name", "red"}, {"type", "constant"}, {"value", {1, 0, 0}}},
                       {{"name", "product"}, {"type", "scale"}, {"first", 0}, {"second", 0}}};
  right["materials"][0]["textures"] = {{{"input", "reflectance"}, {"texture", 1}, {"meaning", "value"}}};
  right["shapes"][0]["alpha"] = 0;
  CHECK(error_of(right) == "");
  const auto wrong = [&](const char* pointer, const nlohmann::json& value) {
    nlohmann::json json = right;
    json[nlohmann::json::json_pointer(pointer)] = value;
    return error_of(json);
  };
  CHECK(wrong("/textures/0/type", "marble") ==
        "a.json: textures[0]: \"type\" is \"marble\"; valid are constant, image, scale, mix, checkerboard, "
        "cubes, dots, bilinear, direction_mix, noise, placed");
  CHECK(wrong("/textures/0/value", "red") == "a.json: textures[0]: \"value\" must be a list");
  const nlohmann::json image = {
      {"name", ""},           {"type", "image"},       {"wrap", "repeat"},
      {"filter", "bilinear"}, {"file", "no-such.exr"}, {"uv", {{1, 0, 0}, {0, 1, 0}}}};
  const auto wrapped = [&](const nlohmann::json& wrap) {
    nlohmann::json changed = image;
    changed["wrap"] = wrap;
    return wrong("/textures/0", changed);
  };
  CHECK(wrapped("repeat") == "");
  CHECK(wrapped({"clamp", "black"}) == "");
  CHECK(wrapped({"clamp", "mirror"}) ==
        "a.json: textures[0]: \"wrap\" is \"mirror\"; valid are repeat, clamp, black");
  CHECK(wrapped({"clamp", 1}) == "a.json: textures[0]: \"wrap\" must be a string");
  CHECK(wrapped({"clamp"}).starts_with("a.json: textures[0]: \"wrap\" "));
  CHECK(wrong("/textures/1/first", 1).starts_with("a.json: texture 1 "));
  CHECK(
      wrong("/materials/0/textures/0/input", "shine")
          .starts_with("a.json: materials[0]: textures[0]: \"input\" is \"shine\"; valid are reflectance, "));
  CHECK(wrong("/materials/0/textures/0/texture", 2) == "a.json: material 0 names texture 2; there are 2");
  CHECK(wrong("/materials/0/textures/0/input", "eta") ==
        "a.json: material 0 has a texture for its eta, and its model has none");
  CHECK(wrong("/materials/0/bump_map", 7) == "a.json: material 0 names texture 7; there are 2");
  CHECK(wrong("/shapes/0/alpha", 2) == "a.json: shapes[0]: \"alpha\" is 2; there are 2 textures");
  right["textures"].push_back({{"name", "board"},
                               {"type", "checkerboard"},
                               {"first", 0},
                               {"second", 1},
                               {"uv", {{1, 0, 0}, {0, 1}}}});
  CHECK(error_of(right) == "a.json: textures[2]: \"uv\" must be 2 rows of 3 numbers");
  const nlohmann::json noise = {{"name", "clouds"}, {"type", "noise"}, {"pattern", "fbm"}, {"octaves", 64},
                                {"roughness", 0.5}, {"scale", 1},      {"variation", 0.2}};
  const nlohmann::json placed = {{"name", "there"},
                                 {"type", "placed"},
                                 {"texture", 2},
                                 {"placement", "space"},
                                 {"to_texture", {{1, 0, 0, 5}, {0, 1, 0, 0}, {0, 0, 1, 0}}}};
  right["textures"][2] = noise;
  right["textures"].push_back(placed);
  CHECK(error_of(right) == "");
  CHECK(wrong("/textures/2/octaves", 65) == "a.json: textures[2]: \"octaves\" is 65; at most 64 are valid");
  CHECK(wrong("/textures/2/pattern", "wood") ==
        "a.json: textures[2]: \"pattern\" is \"wood\"; valid are fbm, wrinkled, windy, marble");
  CHECK(wrong("/textures/3/placement", "cube") ==
        "a.json: textures[3]: \"placement\" is \"cube\"; valid are space, planar, spherical, cylindrical");
  CHECK(wrong("/textures/3/to_texture", {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1}}) ==
        "a.json: textures[3]: \"to_texture\" must be 3 rows of 4 numbers");
  CHECK(wrong("/textures/3/texture", 1).ends_with("texture 3 places texture 1, which is no pattern"));
}

}  // namespace twinray::test
