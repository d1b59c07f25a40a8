// SPDX-License-Identifier: Apache-2.0
// What surfaces of glTF files are made of, in tests.
#pragma once
#include "io/picture/png.h"
#include "tests/io/gltf/file.h"
#include "tests/support/catch.h"

namespace twinray::test {

inline Principled model_of(const GltfFile& file) {
  const LoadedScene loaded = file.load();
  CHECK(loaded.warnings.empty());
  return std::get<Principled>(loaded.scene.materials.at(0).model);
}

/// A surface whose material has one extension.
inline GltfFile extended(const char* name, const nlohmann::json& properties) {
  GltfFile file = gltf_surface({{"extensions", {{name, properties}}}});
  file.json["extensionsUsed"] = {name};
  return file;
}

/// A picture of one row: 188 51 0, and 0 102 255.
inline std::string picture_bytes() {
  const auto bytes = encode_png(ByteImage{2, 1, {188, 51, 0, 0, 102, 255}}, {});
  return {bytes.begin(), bytes.end()};
}

inline int add_picture(GltfFile& file, const nlohmann::json& sampler = nlohmann::json::object()) {
  const int image =
      file.add("images", {{"bufferView", file.view(picture_bytes())}, {"mimeType", "image/png"}});
  return file.add("textures", {{"source", image}, {"sampler", file.add("samplers", sampler)}});
}

/// What an input of the first material is at texture coordinates.
inline Rgb input_at(const LoadedScene& loaded, MaterialInput input, Vec2 uv) {
  for (const TextureUse& use : loaded.scene.materials[0].textures)
    if (use.input == input) return evaluate(loaded.scene.textures, use.texture, {.uv = uv});
  return {-1, -1, -1};
}

inline constexpr Vec2 left{0.25f, 0.5f}, right{0.75f, 0.5f};

}  // namespace twinray::test
