// SPDX-License-Identifier: Apache-2.0
// Private: materials of Wavefront MTL files.
#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "core/light.h"
#include "core/material.h"
#include "core/texture.h"
#include "io/load_options.h"
#include "io/obj/reader.h"
#include "io/picture/texture_file.h"

namespace twinray {

/// What faces of a material are made of, and what they emit.
struct ObjSurface {
  std::uint32_t material = 0;        ///< Index into ObjMaterials::materials.
  std::uint32_t alpha = no_texture;  ///< Index into ObjMaterials::textures.
  MeshLight glow;                    ///< But for its shape.
};

/// The materials of MTL files, as a scene has them. docs/meshes.md says what is made of each value.
class ObjMaterials {
 public:
  ObjMaterials(const ObjModel& model, const LoadOptions& options, WarningList& warnings)
      : model_(model), options_(options), warnings_(warnings) {}

  /// Of a number that faces have; -1: none, which is grey.
  ObjSurface surface(int number);
  /// The same with a picture of its own for what it reflects.
  ObjSurface painted(const ObjSurface& surface, const ImageTexture& picture);
  /// Whether its texture coordinates matter.
  bool is_textured(const ObjSurface& surface) const;
  /// Warns of something in the file of the material that was asked for last.
  void warn(const std::string& message);

  std::vector<Material> materials;
  std::vector<Texture> textures;

 private:
  void warn_of_ranges(const tinyobj::material_t& from);
  ObjSurface make(const tinyobj::material_t& from);
  void add_color(const tinyobj::material_t& from, Material& to);
  void add_specular(const tinyobj::material_t& from, Material& to);
  void add_textures(const tinyobj::material_t& from, Material& to);
  void add_relief(const tinyobj::material_t& from, Material& to);
  std::uint32_t alpha_of(const tinyobj::material_t& from, const Material& made);
  MeshLight glow_of(const tinyobj::material_t& from);
  /// A file's pixels. A warning says what is wrong with them.
  LoadedTexture load(const std::string& name, const PictureMeaning& meaning);
  std::uint32_t picture(const std::string& name, const tinyobj::texture_option_t& how,
                        const PictureMeaning& meaning);
  std::uint32_t constant(const Rgb& value);
  std::uint32_t scaled(std::uint32_t texture, const Rgb& scale);
  std::string path_of(const std::string& name) const;

  const ObjModel& model_;
  const LoadOptions& options_;
  WarningList& warnings_;
  std::string file_;  ///< The one that describes the material that was asked for last.
  std::map<int, ObjSurface> made_;
};

}  // namespace twinray
