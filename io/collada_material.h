// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/material.h"
#include "core/rgb.h"
#include "io/collada_effect.h"

namespace twinray {

/// The material of a surface: what it reflects, and what it emits.
struct ColladaMaterial {
  std::uint32_t index = 0;  ///< Into ColladaMaterials::materials().
  Rgb radiance;             ///< Black for most.
};

/// The materials that a scene uses, each read once, in the order of their first use.
///
/// CGL's emission, mirror, refraction, glass and microfacet become those models; a surface with CGL emission
/// reflects nothing. A common profile's diffuse color becomes Lambert; its emission color makes it an
/// emitter. Without a material, and for a texture, a surface is Lambert of 0.5. What is read and not rendered
/// (textures, transparency, reflection) is a warning.
class ColladaMaterials {
 public:
  explicit ColladaMaterials(ColladaDocument& document) : document_(document) {}

  /// The material bound to a symbol by an <instance_geometry>; an empty symbol means the first one bound, and
  /// one that is not bound, with a warning, the <material> with that id.
  ColladaMaterial bound(const XmlElement& instance, const std::string& symbol);
  /// The material of a surface that only emits.
  std::uint32_t black();

  const std::vector<Material>& materials() const { return materials_; }
  /// Names of the materials whose specular color is not black: that part is not rendered.
  const std::vector<std::string>& with_specular() const { return with_specular_; }

 private:
  ColladaMaterial read(const XmlElement& material);
  ColladaMaterial once(const XmlElement& material);
  ColladaMaterial read_common(const ColladaEffect& effect, const std::string& name);
  ColladaMaterial read_cgl(const XmlElement& model, const std::string& name);
  Rgb read_reflectance(const ColladaEffect& effect);
  Rgb read_emission(const ColladaEffect& effect);
  std::optional<Rgb> color_in(const ColladaEffect& effect, const XmlElement& slot, float most,
                              const char* otherwise);
  void warn_of_transparency(const ColladaEffect& effect);
  void warn_of_reflection(const ColladaEffect& effect);
  ColladaMaterial add(const std::string& name, const SurfaceModel& model, const Rgb& radiance = {});
  std::uint32_t shared(std::uint32_t& index, const std::string& name, const Lambert& model);

  static constexpr std::uint32_t none = 0xffffffff;
  ColladaDocument& document_;
  std::vector<Material> materials_;
  std::map<XmlElement, ColladaMaterial> known_;
  std::vector<std::string> with_specular_;
  std::uint32_t grey_ = none, black_ = none;
};

}  // namespace twinray
