// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/material.h"
#include "core/texture.h"
#include "io/pbrt/context.h"
#include "io/pbrt/parameters.h"
#include "io/picture/image_file.h"

namespace twinray {

/// The textures that a file names, as a scene has them. What core/texture.h has no pattern for stands for its
/// mean.
class PbrtTextures {
 public:
  /// A texture, and the value that stands for it where a number is needed.
  struct Named {
    std::uint32_t index = 0;  ///< Into `textures`.
    Rgb mean;
  };

  explicit PbrtTextures(PbrtContext& context) : context_(context) {}

  /// Defines the texture that a Texture statement describes: its name, "float" or "spectrum", and its class.
  void define(const std::string& name, const std::string& type, const std::string& texture_class,
              const PbrtParameters& parameters);
  /// The texture of this kind that a parameter of type texture names. Where there is only one of the other
  /// kind it is that one, with a warning, since pbrt refuses it. Throws Error where none of this name was
  /// defined before.
  const Named& named(const PbrtParameters& parameters, const PbrtParameter& parameter,
                     PictureChannels kind) const;

  /// The texture of a material's "normalmap", a picture's file; no_texture where it has none.
  std::uint32_t normal_map(const PbrtParameters& parameters);
  /// The texture of a material's "displacement", a height; no_texture where it has none, or one everywhere.
  std::uint32_t bump_map(const PbrtParameters& parameters);
  /// The texture of a shape's "alpha"; no_texture where it is 1 everywhere.
  std::uint32_t alpha(const PbrtParameters& parameters);
  /// The texture times a number.
  std::uint32_t scaled(std::uint32_t texture, float scale);
  /// Whether a texture is this number or less everywhere, as far as its kind tells.
  bool is_at_most(std::uint32_t texture, float number) const;

  std::vector<Texture> textures;

 private:
  Named add(const TextureModel& model, const Rgb& mean);
  Named constant(const Rgb& value) { return add(ConstantTexture{value}, value); }
  Named value(const PbrtParameters& parameters, const char* name, float fallback, PictureChannels kind);
  Named make(const std::string& texture_class, const PbrtParameters& parameters, PictureChannels channels);
  Named read_picture(const PbrtParameters& parameters, PictureChannels channels);
  /// White without the texture.
  Named inverted(const Named& from);
  Named instead(const Rgb& mean, const PbrtParameters& parameters, const char* why);
  /// By a picture's "encoding".
  PictureRole role_of(const PbrtParameters& parameters);
  UvTransform read_mapping(const PbrtParameters& parameters);

  PbrtContext& context_;
  std::map<std::pair<std::string, PictureChannels>, Named> named_;
};

}  // namespace twinray
