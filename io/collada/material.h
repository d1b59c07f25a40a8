// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/light.h"
#include "core/material.h"
#include "core/rgb.h"
#include "io/collada/effect.h"
#include "io/collada/texture.h"

namespace twinray {

/// The material of a surface: what it reflects, what it emits, and where there is none of it.
struct ColladaMaterial {
  std::uint32_t index = 0;           ///< Into ColladaMaterials::materials().
  MeshLight glow;                    ///< But for its shape; black for most.
  std::uint32_t alpha = no_texture;  ///< Index into ColladaMaterials::textures(): it cuts holes.
  bool is_textured = false;          ///< Its texture coordinates matter.
  std::string texcoord;              ///< The name by which its textures ask for them.
};

/// A material as an <instance_material> binds it.
struct ColladaBinding {
  ColladaMaterial material;
  std::optional<std::uint32_t> uv_set;  ///< The set of texture coordinates; none: the first one.
  std::optional<XmlElement> bind;       ///< The <bind_vertex_input> that says it.
};

/// The materials that a scene uses, each read once, in the order of their first use.
///
/// CGL's emission, mirror, refraction, glass and microfacet become those models; a surface with CGL emission
/// reflects nothing. A common profile's diffuse color or texture becomes Lambert; its emission makes it an
/// emitter; a texture of its transparency cuts holes. Without a material a surface is Lambert of 0.5. What is
/// read and not rendered (transparency that is even, reflection; textures by CS184's rules) is a warning.
class ColladaMaterials {
 public:
  ColladaMaterials(ColladaDocument& document, PictureReader read)
      : document_(document), textures_(document, std::move(read)) {}

  /// The material bound to a symbol by an <instance_geometry>; an empty symbol means the first one bound, and
  /// one that is not bound, with a warning, the <material> with that id.
  ColladaBinding bound(const XmlElement& instance, const std::string& symbol);
  /// The material of a surface that only emits.
  std::uint32_t black();

  const std::vector<Material>& materials() const { return materials_; }
  const std::vector<Texture>& textures() const { return textures_.textures; }
  /// Names of the materials whose specular color is not black: that part is not rendered.
  const std::vector<std::string>& with_specular() const { return with_specular_; }

 private:
  ColladaMaterial read(const XmlElement& material);
  ColladaMaterial once(const XmlElement& material);
  ColladaMaterial read_common(const ColladaEffect& effect, const std::string& name);
  ColladaMaterial read_cgl(const XmlElement& model, const std::string& name);
  void read_diffuse(const ColladaEffect& effect, Material& material, ColladaMaterial& made);
  void read_emission(const ColladaEffect& effect, ColladaMaterial& made);
  void read_transparency(const ColladaEffect& effect, ColladaMaterial& made);
  void add_holes(const ColladaEffect& effect, const XmlElement& slot, const std::string& mode, float amount,
                 ColladaMaterial& made);
  /// The texture of a slot as a picture of this meaning; no_texture, with a warning, where it cannot be used.
  std::uint32_t texture_in(const ColladaEffect& effect, const XmlElement& slot, const PictureMeaning& meaning,
                           const char* otherwise, ColladaMaterial& made);
  void warn_of_reflection(const ColladaEffect& effect);
  ColladaMaterial add(Material material, const Rgb& radiance = {});
  std::uint32_t shared(std::uint32_t& index, const std::string& name, const Lambert& model);

  static constexpr std::uint32_t none = 0xffffffff;
  ColladaDocument& document_;
  ColladaTextures textures_;
  std::vector<Material> materials_;
  std::map<XmlElement, ColladaMaterial> known_;
  std::vector<std::string> with_specular_;
  std::uint32_t grey_ = none, black_ = none;
};

}  // namespace twinray
