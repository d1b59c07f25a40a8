// SPDX-License-Identifier: Apache-2.0
// An <effect> and its parameters. A slot of its shading (<diffuse>, <transparency>, ...) holds a value, names
// a parameter that does, or names a texture, by way of a sampler, a surface and an image.
#pragma once
#include <array>
#include <optional>
#include <string>

#include "core/rgb.h"
#include "io/collada/document.h"

namespace twinray {

/// What a <texture> leads to, by way of a sampler, a surface and an image.
struct ColladaTextureUse {
  XmlElement element;                 ///< The <texture>.
  std::string name;                   ///< Of the image's file, as far as the references lead.
  std::string from_file;              ///< The document that names it; empty where no image does.
  std::optional<XmlElement> sampler;  ///< The <sampler2D>.
  std::string texcoord;               ///< What a <bind_vertex_input> names.
};

/// The common profile of an <effect> as an <instance_effect> uses it.
class ColladaEffect {
 public:
  ColladaEffect(const XmlElement& effect, const XmlElement& instance, ColladaDocument& document)
      : effect_(effect), instance_(instance), document_(document) {}

  const XmlElement& element() const { return effect_; }
  /// The <phong>, <blinn>, <lambert> or <constant>.
  std::optional<XmlElement> shading() const;
  /// A slot of the shading.
  std::optional<XmlElement> slot(const char* name) const;

  /// The color in a slot, each component within [0, most]; nothing for a texture. Throws Error where there is
  /// neither, and for a parameter that is not defined.
  std::optional<Rgb> color(const XmlElement& slot, float most) const;
  /// The texture in a slot; nothing where there is none.
  std::optional<ColladaTextureUse> texture(const XmlElement& slot) const;

  /// How much of the surface is there, in the opaque modes A_ONE, A_ZERO, RGB_ONE and RGB_ZERO; the mean of
  /// three channels for the last two. Nothing where a texture says so. Throws Error for what makes no sense.
  std::optional<double> opacity() const;
  /// That mode; A_ONE where the file names none. Throws Error for another word.
  std::string opaque_mode() const;
  /// The factor of the transparency. Throws Error for what makes no sense.
  double transparency() const { return scalar("transparency", 1); }
  /// reflective times reflectivity, the greatest component; nothing where a texture says so. Throws Error for
  /// what makes no sense.
  std::optional<double> reflectivity() const;

 private:
  std::optional<XmlElement> parameter(const std::string& sid) const;
  std::optional<XmlElement> holder(const XmlElement& slot, std::initializer_list<const char*> types) const;
  std::optional<std::array<double, 4>> rgba(const char* slot, double alpha) const;
  double scalar(const char* slot, double fallback) const;
  std::optional<XmlElement> image(const std::string& reference) const;

  XmlElement effect_, instance_;
  ColladaDocument& document_;
};

}  // namespace twinray
