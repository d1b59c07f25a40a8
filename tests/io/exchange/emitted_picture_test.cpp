// SPDX-License-Identifier: Apache-2.0
// Pictures that meshes emit, in exchange form.
#include "core/error.h"
#include "io/exchange/reader.h"
#include "io/input_file.h"
#include "io/output_file.h"
#include "io/picture/image_file.h"
#include "tests/io/exchange/small_scene.h"
#include "tests/support/catch.h"
#include "tests/support/json.h"
#include "tests/support/meshes.h"
#include "tests/support/round_trip.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {

TEST_CASE("a picture that a mesh emits may be below 0 in a channel, no other, and not in its luminance") {
  const auto error = [](const LightSource& source, const Rgb& pixel) -> std::string {
    Scene scene = scene_of(box_mesh(), Lambert{});
    Image emitted(2, 2);
    emitted.pixels[3] = pixel;
    const auto kept = std::make_shared<const Image>(emitted);
    scene.lights = {{"", source}};
    if (auto* mesh = std::get_if<MeshLight>(&scene.lights[0].source)) {
      mesh->picture = kept;
      scene.bindings[0].light = 0;
    } else {
      std::get<EnvironmentLight>(scene.lights[0].source).map = kept;
    }
    try {
      const RoundTrip trip = round_trip(scene, "a.json");
      if (std::holds_alternative<MeshLight>(source))
        CHECK(std::get<MeshLight>(trip.scene.lights[0].source).picture->pixels == emitted.pixels);
    } catch (const Error& fault) {
      return fault.what();
    }
    return "";
  };
  constexpr Rgb dark{-1, 1, 1}, darker{1, -1, 1};
  CHECK(error(MeshLight{}, dark) == "");
  CHECK(error(MeshLight{}, darker).ends_with("a-light-0.exr has a pixel that is no radiance"));
  CHECK(error(EnvironmentLight{}, white) == "");
  CHECK(error(EnvironmentLight{}, dark).ends_with("a-light-0.exr has a pixel that is no radiance"));
}

TEST_CASE("a picture that a mesh emits lies as its keys say, each of which may be left out") {
  const TemporaryFolder folder;
  write_png(folder.file("grey.png"), ByteImage{2, 1, {188, 188, 188, 188, 188, 188}});
  nlohmann::json json = small();
  json["lights"][0] = {{"name", "lamp"},  {"type", "mesh"},        {"shape", 0},
                       {"side", "front"}, {"radiance", {1, 1, 1}}, {"file", "grey.png"}};
  json["shapes"][0] = {{"name", "m"}, {"type", "mesh"}, {"file", "m.ply"}, {"material", 0}, {"light", 0}};
  write_file(folder.file("m.ply"),
             "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
             "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
             "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  const auto light = [&] {
    LoadOptions strict;
    strict.strict = true;  // No key is unknown.
    return std::get<MeshLight>(
        read_exchange(json.dump(), folder.file("a.json"), strict,
                      [](const std::string& path) { return read_input_file(path, "file"); })
            .scene.lights[0]
            .source);
  };
  CHECK(light().filter == TextureFilter::bilinear);
  json["lights"][0]["filter"] = "nearest";
  CHECK(light().filter == TextureFilter::nearest);
  json["lights"][0]["wrap"] = "repeat";
  CHECK(light().wrap.u == WrapMode::repeat);
}

}  // namespace twinray::test
