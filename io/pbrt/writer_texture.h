// SPDX-License-Identifier: Apache-2.0
// Textures in pbrt's text. There a texture is one of colours or one of numbers; here the same may be either,
// and is written as what it is used as.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "io/written_scene.h"

namespace twinray {

enum class PbrtTextureKind { color, number };

class PbrtTextureWriter {
 public:
  PbrtTextureWriter(const Scene& scene, SceneOutput& output) : textures(scene.textures), output_(output) {}

  /// The name of a texture, whose statement is added to the text the first time. A number is its red.
  std::string named(std::uint32_t texture, PbrtTextureKind kind);
  /// The index of a texture times a number, which is added.
  std::uint32_t scaled(std::uint32_t texture, float factor);
  /// The name of a texture's product with itself, times a number.
  std::string squared(std::uint32_t texture, float factor);
  /// The name of an EXR file that has the directions of a normal map over the texture coordinates.
  std::string normal_map(std::uint32_t texture);

  std::vector<Texture> textures;  ///< The scene's, and those that were added.
  std::string text;               ///< The statements.

 private:
  std::string define(const std::string& name, const std::string& type, const std::string& rest);
  /// A parameter that is a texture or, of a constant one, its value.
  std::string part(const char* name, std::uint32_t texture, PbrtTextureKind kind);
  std::string picture(const MipMap& image, PbrtTextureKind kind);
  std::string wrap(const Wrap& wrap);
  std::string mapping(const UvTransform& uv);
  std::string image_rest(const ImageTexture& texture, PbrtTextureKind kind);
  std::string baked_rest(std::uint32_t texture, PbrtTextureKind kind);
  std::string scale_rest(std::uint32_t index, const ScaleTexture& texture, PbrtTextureKind kind);
  std::string rest_of(std::uint32_t index, PbrtTextureKind kind);
  std::string pattern_rest(const CheckerboardTexture& board, PbrtTextureKind kind);
  std::string pattern_rest(const CubesTexture& cubes, PbrtTextureKind kind);
  std::string pattern_rest(const DotsTexture& dots, PbrtTextureKind kind);
  std::string pattern_rest(const BilinearTexture& square, PbrtTextureKind kind);
  std::string pattern_rest(const DirectionMixTexture& mix, PbrtTextureKind kind);
  std::string noise_rest(const NoiseTexture& texture, PbrtTextureKind kind);
  /// The words of a pattern in the plane that has a transform of its own there.
  std::string planar(const PlacedTexture& texture, const UvTransform& uv);
  /// The statement, within the transform by which the pattern lies.
  std::string define_placed(const std::string& name, const PlacedTexture& texture, PbrtTextureKind kind);
  std::string add_file(Image image);

  SceneOutput& output_;
  UniqueNames names_;
  std::map<std::pair<std::uint32_t, PbrtTextureKind>, std::string> named_;
  std::map<std::pair<const MipMap*, PbrtTextureKind>, std::string> pictures_;
  std::map<std::uint32_t, std::string> normal_maps_;
  std::size_t files_ = 0;
};

}  // namespace twinray
