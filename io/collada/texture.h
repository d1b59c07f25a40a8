// SPDX-License-Identifier: Apache-2.0
// The pictures on the surfaces of a COLLADA file.
#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "core/texture.h"
#include "io/collada/effect.h"
#include "io/picture/texture_file.h"

namespace twinray {

/// Reads the picture of a path (io/picture/texture_file.h).
using PictureReader =
    std::function<LoadedTexture(const std::string&, const PictureMeaning&, const LoadOptions&)>;

/// The textures that a scene uses, each read once.
class ColladaTextures {
 public:
  ColladaTextures(ColladaDocument& document, PictureReader read)
      : document_(document), read_(std::move(read)) {}

  /// The index of a texture. One whose file cannot be used is magenta, which a warning says.
  std::uint32_t picture(const ColladaTextureUse& use, const PictureMeaning& meaning);
  std::uint32_t constant(float value);
  /// Adds one that nobody else needs.
  std::uint32_t add(const TextureModel& model);

  /// Whether it is a picture that is 1 all over.
  bool is_one(std::uint32_t texture) const;
  /// Whether something was wrong with its picture, which a warning has said.
  bool is_faulty(std::uint32_t texture) const;

  std::vector<Texture> textures;

 private:
  /// How a picture goes on beside itself, and where it lies.
  struct Sampling {
    Wrap wrap;
    bool mirrors_u = false, mirrors_v = false;
    TextureFilter filter = TextureFilter::stochastic;
    UvTransform uv;
  };

  Sampling sampling_of(const ColladaTextureUse& use);
  /// What Maya's exporters, and those that follow them, say of where a picture lies: it is repeated so many
  /// times, perhaps mirrored, and then moved. Angles are warned of. Throws Error.
  void place(const XmlElement& texture, Sampling& sampling);
  std::shared_ptr<const MipMap> image(const std::string& path, const ColladaTextureUse& use,
                                      const PictureMeaning& meaning, const Sampling& sampling);

  ColladaDocument& document_;
  PictureReader read_;
  /// By path, role, channels and in which directions it is mirrored.
  std::map<std::tuple<std::string, int, int, int>, std::shared_ptr<const MipMap>> images_;
  /// By what they are used by: an effect's parameters differ by the material that instances it.
  std::map<std::tuple<XmlElement, std::optional<XmlElement>, std::string, int, int>, std::uint32_t> pictures_;
  std::set<std::shared_ptr<const MipMap>> faulty_;
};

}  // namespace twinray
