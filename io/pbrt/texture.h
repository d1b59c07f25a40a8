// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/material.h"
#include "core/texture.h"
#include "core/transform.h"
#include "io/pbrt/context.h"
#include "io/pbrt/parameters.h"
#include "io/picture/image_file.h"

namespace twinray {

/// What a Texture statement says, but for the texture's name and type.
struct PbrtTextureStatement {
  const std::string& texture_class;
  const PbrtParameters& parameters;
  const Transform& to_world;  ///< From the space in which patterns lie that go by points.
};

/// The textures that a file names, as a scene has them.
class PbrtTextures {
 public:
  /// A texture, and the value that stands for it where a number is needed.
  struct Named {
    std::uint32_t index = 0;  ///< Into `textures`.
    Rgb mean;
  };

  explicit PbrtTextures(PbrtContext& context) : context_(context) {}

  /// Defines the texture that a statement describes; the type is "float" or "spectrum".
  void define(const std::string& name, const std::string& type, const PbrtTextureStatement& statement);
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

  /// Whether the surface's texture coordinates matter to a texture.
  bool needs_coordinates(std::uint32_t texture) const { return by_coordinates_[texture]; }

  std::vector<Texture> textures;

 private:
  /// How a pattern in the plane lies: by the surface's coordinates, or by points.
  struct Mapping {
    UvTransform uv;
    std::optional<PlacedTexture> by_points;  ///< Without its texture.
  };

  Named named(std::uint32_t index);
  Named add(const TextureModel& model);
  Named constant(const Rgb& value) { return add(ConstantTexture{value}); }
  Named value(const PbrtParameters& parameters, const char* name, float fallback, PictureChannels kind);
  Named make(const PbrtTextureStatement& statement, PictureChannels channels);
  Named mix_by_direction(const PbrtTextureStatement& statement, PictureChannels channels);
  Named checkerboard(const PbrtTextureStatement& statement, PictureChannels channels);
  Named corners(const PbrtTextureStatement& statement, PictureChannels channels);
  Named noise(const PbrtTextureStatement& statement, PictureChannels channels);
  Named read_picture(const PbrtTextureStatement& statement, PictureChannels channels);
  /// A pattern, or what is placed.
  Named placed(const TextureModel& pattern, const std::optional<PlacedTexture>& place);
  /// A pattern of two textures: of those, where they are placed by themselves.
  template <typename Pattern>
  Named placed_parts(Pattern pattern, const std::optional<PlacedTexture>& place);
  /// White without the texture.
  Named inverted(const Named& from);
  /// By a picture's "encoding".
  PictureRole role_of(const PbrtParameters& parameters);
  Mapping read_mapping(const PbrtTextureStatement& statement);
  /// Of patterns in space; nothing where these are the scene's.
  std::optional<PlacedTexture> space_of(const PbrtTextureStatement& statement);

  PbrtContext& context_;
  std::map<std::pair<std::string, PictureChannels>, Named> named_;
  std::vector<Rgb> means_;            ///< Of the textures,
  std::vector<bool> by_coordinates_;  ///< and whether they go by the surface's coordinates.
};

}  // namespace twinray
