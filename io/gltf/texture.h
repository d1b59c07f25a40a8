// SPDX-License-Identifier: Apache-2.0
// The textures of a glTF file as the scene's: pictures that stand in files or in buffers, and what is made of
// them.
#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "core/material.h"
#include "core/texture.h"
#include "io/gltf/slot.h"
#include "io/picture/picture_meaning.h"
#include "io/picture/texture_file.h"

namespace twinray {

class GltfDocument;

class GltfTextures {
 public:
  explicit GltfTextures(GltfDocument& document) : document_(document) {}

  // Each gives the index of a texture; the same one for the same arguments.

  std::uint32_t constant(const Rgb& value);
  /// A slot's picture. One that cannot be used is magenta, which a warning says; without a picture that is
  /// known here it is white.
  std::uint32_t picture(const GltfSlot& slot, const PictureMeaning& meaning,
                        CoordinateSet coordinates = CoordinateSet::first);
  /// A texture times a factor.
  std::uint32_t scaled(std::uint32_t texture, const Rgb& factor);
  /// Two textures, the second of which may be no_texture.
  std::uint32_t product(std::uint32_t first, std::uint32_t second);
  /// A normal map whose x and y are times the slot's scale; `is_mirrored`: y the other way round.
  std::uint32_t normal_map(const GltfSlot& slot, bool is_mirrored);
  /// Likewise of the direction in the plane of the surface that its x and y are.
  std::uint32_t tangent_map(const GltfSlot& slot, bool is_mirrored);
  /// 1 where a number is at least a limit, else 0: a steep ramp, whose ends the alpha test cuts off.
  std::uint32_t at_least(std::uint32_t texture, float factor, float limit);

  /// The pixels of a slot's picture.
  std::shared_ptr<const MipMap> image(const GltfSlot& slot, const PictureMeaning& meaning);
  /// How it goes on beside the picture.
  Wrap wrap(const GltfSlot& slot) const;

  std::vector<Texture> take() { return std::move(textures_); }
  const std::vector<Texture>& textures() const { return textures_; }
  /// Adds one that nobody else needs.
  std::uint32_t add(const std::string& name, const TextureModel& model);

 private:
  /// A picture of directions from -1 (0) to 1: 1/2 + (c - 1/2) s for the factors x of red and y of green.
  std::uint32_t directions(const GltfSlot& slot, float x, float y);

  struct Wraps {
    int s, t;
    bool is_mirrored() const;
  };

  Wraps wraps(const GltfSlot& slot) const;
  ImageTexture image_texture(const GltfSlot& slot, const PictureMeaning& meaning);
  LoadedTexture load(int image, const PictureMeaning& meaning);
  LoadedTexture load_embedded(int image, const PictureMeaning& meaning);
  /// The image of a slot's texture; one in WebP before another. -1: none that is known here.
  int source_of(const GltfSlot& slot) const;
  std::string name_of(const GltfSlot& slot) const;

  GltfDocument& document_;
  std::vector<Texture> textures_;
  /// By image, role, channels and in which directions it is mirrored.
  std::map<std::tuple<int, int, int, int>, std::shared_ptr<const MipMap>> images_;
  using PictureKey = std::tuple<int, int, int, CoordinateSet, std::vector<float>>;
  std::map<PictureKey, std::uint32_t> pictures_;
  std::map<std::tuple<float, float, float>, std::uint32_t> constants_;
};

}  // namespace twinray
