// SPDX-License-Identifier: Apache-2.0
// Private to the writer of glTF: textures as PNG pictures, in the channels where the format has them.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>

#include "core/image.h"
#include "core/scene.h"
#include "io/gltf/writer_file.h"
#include "io/picture/baked_texture.h"

namespace twinray {

/// Of a picture with four channels, the last.
inline constexpr std::size_t alpha_channel = 3;

/// What a picture's red, green and blue are together: a colour, encoded as sRGB; a normal, or a tangent of
/// two parts, whose blue is free for a number. The tangent of a picture without one is that of the
/// coordinates.
enum class GltfColorKind { color, normal, tangent };

/// What the channels of one picture are.
struct GltfChannels {
  /// Of the colour; a texture in `number` stands in for a channel of it. no_texture: white.
  std::uint32_t color = no_texture;
  /// Textures of numbers in red, green, blue and alpha: their red. no_texture: 1.
  std::array<std::uint32_t, 4> number{no_texture, no_texture, no_texture, no_texture};
  GltfColorKind kind = GltfColorKind::color;
  float power = 1;           ///< To which numbers are taken, but for alpha.
  bool turns_green = false;  ///< Of directions: green is 1 less what it was.

  bool is_empty() const {
    return *this == GltfChannels{.kind = kind, .power = power, .turns_green = turns_green};
  }
  auto operator<=>(const GltfChannels&) const = default;
};

/// Whether a picture goes on mirrored on its right, and below.
struct GltfMirrored {
  bool to_right = false, below = false;
};

class GltfTextureWriter {
 public:
  GltfTextureWriter(const Scene& scene, GltfFile& file) : scene_(scene), file_(file) {}

  /// A textureInfo of a picture with these channels, made once.
  GltfJson info(const GltfChannels& channels);
  /// A textureInfo of a picture of what a light has, divided by the brightest number in it.
  GltfJson emission_info(const MeshLight& light, float brightest);

 private:
  GltfJson make(const GltfChannels& channels);
  /// Of a picture that lies like this. What glTF cannot place is written as the half that it mirrors, if the
  /// other half is its mirror image and it can place that: so the reader makes pictures that are mirrored
  /// beside themselves (io/picture/mirrored_picture.h).
  template <typename Picture>
  GltfJson placed_info(const std::string& name, const Picture& picture, const BakedTexture& frame);
  /// Of an image of the file, by its number.
  GltfJson info_of(std::size_t image, const BakedTexture& frame, const GltfMirrored& mirrored = {});
  std::size_t sampler(const BakedTexture& frame, const GltfMirrored& mirrored);
  GltfJson transform(const UvTransform& uv);
  void check_range(const Image& picture);

  const Scene& scene_;
  GltfFile& file_;
  std::map<GltfChannels, GltfJson> made_;
  std::map<std::shared_ptr<const Image>, std::size_t> pictures_;  ///< Their images' numbers.
  std::map<std::array<int, 3>, std::size_t> samplers_;
};

}  // namespace twinray
