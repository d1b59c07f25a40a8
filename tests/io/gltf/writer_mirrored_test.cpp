// SPDX-License-Identifier: Apache-2.0
// Pictures that are mirrored beside themselves, written as glTF and read again.
#include <fmt/format.h>

#include "core/light_set.h"
#include "tests/io/gltf/surface.h"
#include "tests/io/gltf/written.h"
#include "tests/support/round_trip.h"

namespace twinray::test {
namespace {

using nlohmann::json;

constexpr int repeat = 10497, clamp = 33071, mirror = 33648;
constexpr Vec2 points[] = {{0.1f, 0.2f}, {0.8f, 0.3f}, {1.3f, 0.7f}, {2.2f, 1.9f}, {-0.6f, 3.1f}};

/// A surface with a turned picture, as its color or as what it emits.
LoadedScene load_turned(int wrap_s, int wrap_t, const char* slot) {
  GltfFile file = gltf_surface(json::object());
  const auto bytes = encode_png(ByteImage{2, 2, {188, 51, 0, 0, 102, 255, 51, 51, 51, 0, 255, 0}}, {});
  const int image = file.add(
      "images", {{"bufferView", file.view({bytes.begin(), bytes.end()})}, {"mimeType", "image/png"}});
  const int sampler =
      file.add("samplers", {{"wrapS", wrap_s}, {"wrapT", wrap_t}, {"magFilter", 9728}, {"minFilter", 9728}});
  const json placed = {{"rotation", 0.5}, {"scale", {2, 3}}, {"offset", {0.125, 0.25}}};
  const json info = {{"index", file.add("textures", {{"source", image}, {"sampler", sampler}})},
                     {"extensions", {{"KHR_texture_transform", placed}}}};
  json& material = file.json["materials"][0];
  (slot == std::string("emissiveTexture") ? material : material["pbrMetallicRoughness"])[slot] = info;
  material["emissiveFactor"] = {1, 1, 1};
  file.json["extensionsUsed"] = {"KHR_texture_transform"};
  return file.load();
}

}  // namespace

TEST_CASE("written gltf: a turned picture comes back, also where it is mirrored along one axis alone") {
  for (const auto& [s, t] : {std::pair{mirror, repeat},
                             {repeat, mirror},
                             {mirror, clamp},
                             {clamp, mirror},
                             {mirror, mirror},
                             {repeat, repeat}}) {
    CAPTURE(s, t);
    const LoadedScene loaded = load_turned(s, t, "baseColorTexture");
    const RoundTrip trip = round_trip(loaded.scene, "a.gltf");
    CHECK(trip.warnings.empty());
    const auto input = [](const Scene& scene, Vec2 uv) {
      return evaluate(scene.textures, scene.materials[0].textures.at(0).texture, {.uv = uv});
    };
    for (const Vec2 uv : points) CHECK(input(trip.scene, uv) == input(loaded.scene, uv));
    const auto file = json::parse(trip.text);
    if (s != t) CHECK(file["samplers"][0]["wrapS"] == s);
    if (s != t) CHECK(file["samplers"][0]["wrapT"] == t);
  }
}

TEST_CASE("written gltf: a turned picture of light that is mirrored along one axis comes back") {
  const LoadedScene loaded = load_turned(mirror, repeat, "emissiveTexture");
  const RoundTrip trip = round_trip(loaded.scene, "a.gltf");
  CHECK(trip.warnings.empty());
  const auto& before = std::get<MeshLight>(loaded.scene.lights.at(0).source);
  const auto& after = std::get<MeshLight>(trip.scene.lights.at(0).source);
  CHECK(after.picture->pixels.size() == before.picture->pixels.size());
  for (const Vec2 uv : points) {
    CHECK(after.uv(uv).x == Approx(before.uv(uv).x).margin(1e-5));
    CHECK(after.uv(uv).y == Approx(before.uv(uv).y).margin(1e-5));
  }
  CHECK(json::parse(trip.text)["samplers"][0]["wrapS"] == mirror);
}

TEST_CASE("written gltf: another skewed texture is named") {
  Scene scene = scene_of(triangle(), Lambert{});
  const UvTransform skewed{{{1, 0.5f, 0}, {0, 1, 0}}};
  scene.textures = {{"", ImageTexture{picture(), WrapMode::repeat, TextureFilter::nearest, skewed}}};
  scene.materials[0].textures = {{MaterialInput::reflectance, 0}};
  CHECK(round_trip(scene, "a.gltf").warnings ==
        std::vector<std::string>{"a texture that is skewed is not skewed there"});
}

}  // namespace twinray::test
