// SPDX-License-Identifier: Apache-2.0
// Private: materials of Wavefront MTL files.
#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "core/material.h"
#include "core/texture.h"
#include "io/load_options.h"
#include "io/obj/reader.h"

namespace twinray {

/// What faces of a material are made of, and what they emit.
struct ObjSurface {
  std::uint32_t material = 0;        ///< Index into ObjMaterials::materials.
  std::uint32_t alpha = no_texture;  ///< Index into ObjMaterials::textures.
  Rgb radiance;
  std::shared_ptr<const Image> picture = nullptr;  ///< Of the radiance.
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

  std::vector<Material> materials;
  std::vector<Texture> textures;

 private:
  ObjSurface make(const tinyobj::material_t& from);
  void add_textures(const tinyobj::material_t& from, Material& to);
  void add_relief(const tinyobj::material_t& from, Material& to);
  std::uint32_t alpha_of(const tinyobj::material_t& from, const Material& made);
  void add_emission(const tinyobj::material_t& from, ObjSurface& to);
  std::uint32_t picture(const std::string& name, const tinyobj::texture_option_t& how,
                        const PictureMeaning& meaning);
  std::uint32_t number(float value);
  std::string path_of(const std::string& name) const;
  void warn(const std::string& message);

  const ObjModel& model_;
  const LoadOptions& options_;
  WarningList& warnings_;
  std::map<int, ObjSurface> made_;
};

}  // namespace twinray
