// SPDX-License-Identifier: Apache-2.0
#include "io/collada/effect.h"

#include <fmt/format.h>

#include <algorithm>

namespace twinray {
namespace {

/// The <newparam sid> of an effect, or of its profile, or of its technique.
std::optional<XmlElement> find_newparam(const XmlElement& element, const std::string& sid) {
  for (const XmlElement& child : element.children()) {
    if (child.is("newparam") && child.attribute("sid") == sid) return child;
    if (child.is("profile_COMMON") || child.is("technique"))
      if (const auto found = find_newparam(child, sid)) return found;
  }
  return std::nullopt;
}

/// The path that an <image> holds: the text of its <init_from>, or of the <ref> in it (COLLADA 1.5).
std::string path_of(const XmlElement& image) {
  const auto from = image.child("init_from");
  if (!from) return "";
  const auto ref = from->child("ref");
  return ref ? ref->text() : from->text();
}

}  // namespace

std::optional<XmlElement> ColladaEffect::shading() const {
  const auto profile = effect_.child("profile_COMMON");
  const auto technique = profile ? profile->child("technique") : std::nullopt;
  if (!technique) return std::nullopt;
  for (const char* name : {"phong", "blinn", "lambert", "constant"})
    if (const auto found = technique->child(name)) return found;
  return std::nullopt;
}

std::optional<XmlElement> ColladaEffect::slot(const char* name) const {
  const auto model = shading();
  return model ? model->child(name) : std::nullopt;
}

std::optional<XmlElement> ColladaEffect::parameter(const std::string& sid) const {
  for (const XmlElement& set : instance_.children("setparam"))
    if (set.attribute("ref") == sid) return set;
  return find_newparam(effect_, sid);
}

/// The element with the numbers: a child of the slot, or of the parameter that it names. Nothing for a
/// texture.
std::optional<XmlElement> ColladaEffect::holder(const XmlElement& slot,
                                                std::initializer_list<const char*> types) const {
  for (const char* type : types)
    if (const auto value = slot.child(type)) return value;
  if (slot.child("texture")) return std::nullopt;
  const auto param = slot.child("param");
  if (!param)
    slot.fail(fmt::format("<{}> needs a <{}>, a <param> or a <texture>", slot.name(), *types.begin()));
  const auto definition = parameter(param->required_attribute("ref"));
  for (const char* type : types)
    if (const auto value = definition ? definition->child(type) : std::nullopt) return value;
  throw error_at(param->attribute_place("ref"),
                 "no <newparam> of this effect with this sid has a <" +
                     fmt::format("{}>", fmt::join(types.begin() + 1, types.end(), "> or <")));
}

std::optional<Rgb> ColladaEffect::color(const XmlElement& slot, float most) const {
  const auto value = holder(slot, {"color", "float3", "float4"});
  return value ? std::optional(read_color(*value, most)) : std::nullopt;
}

std::optional<std::array<double, 4>> ColladaEffect::rgba(const char* name, double alpha) const {
  const auto element = slot(name);
  if (!element) return std::array<double, 4>{1, 1, 1, alpha};
  const auto value = holder(*element, {"color", "float3", "float4"});
  if (!value) return std::nullopt;
  const auto numbers = value->doubles();
  if (numbers.size() != 3 && numbers.size() != 4)
    value->fail(fmt::format("<{}> has {} numbers; a color has 3 (red, green, blue), or 4 with alpha",
                            value->name(), numbers.size()));
  return std::array<double, 4>{numbers[0], numbers[1], numbers[2], numbers.size() > 3 ? numbers[3] : alpha};
}

double ColladaEffect::scalar(const char* name, double fallback) const {
  const auto element = slot(name);
  const auto value = element ? holder(*element, {"float", "float"}) : std::nullopt;
  return value ? value->number() : fallback;
}

std::optional<double> ColladaEffect::opacity() const {
  const auto transparent = slot("transparent");
  if (!transparent && !slot("transparency")) return 1;
  const auto color = rgba("transparent", 1);
  if (!color) return std::nullopt;
  const std::string mode = opaque_mode();
  const double mean = ((*color)[0] + (*color)[1] + (*color)[2]) / 3;
  const double there = (mode[0] == 'A' ? (*color)[3] : mean) * transparency();
  return mode.ends_with("ONE") ? there : 1 - there;
}

std::string ColladaEffect::opaque_mode() const {
  const auto transparent = slot("transparent");
  const std::string mode = transparent ? transparent->attribute("opaque").value_or("A_ONE") : "A_ONE";
  for (const char* known : {"A_ONE", "A_ZERO", "RGB_ONE", "RGB_ZERO"})
    if (mode == known) return mode;
  throw error_at(
      transparent->attribute_place("opaque"),
      fmt::format("\"{}\" is not an opaque mode; valid are A_ONE, A_ZERO, RGB_ONE and RGB_ZERO", mode));
}

std::optional<double> ColladaEffect::reflectivity() const {
  if (!slot("reflective")) return 0;
  const auto color = rgba("reflective", 1);
  if (!color) return std::nullopt;
  return std::max({(*color)[0], (*color)[1], (*color)[2]}) * scalar("reflectivity", 1);
}

/// The image that an id means: of the document, or of the effect itself.
std::optional<XmlElement> ColladaEffect::image(const std::string& reference) const {
  const std::string id = !reference.empty() && reference[0] == '#' ? reference.substr(1) : reference;
  return document_.find(effect_, id, "image");
}

std::optional<ColladaTextureUse> ColladaEffect::texture(const XmlElement& slot) const {
  const auto element = slot.child("texture");
  if (!element) return std::nullopt;
  ColladaTextureUse use{*element, element->attribute("texture").value_or(""), {}, {}, {}};
  use.texcoord = element->attribute("texcoord").value_or("");
  for (const char* type : {"sampler2D", "surface"}) {
    const auto definition = parameter(use.name);
    const auto value = definition ? definition->child(type) : std::nullopt;
    if (!value) continue;
    if (value->is("sampler2D")) use.sampler = value;
    if (const auto instance = value->child("instance_image"))
      use.name = instance->attribute("url").value_or(use.name);
    if (const auto next = value->child(value->is("surface") ? "init_from" : "source"))
      use.name = next->text();
  }
  const auto found = image(use.name);
  const std::string path = found ? path_of(*found) : "";
  if (path.empty()) return use;
  use.name = path;
  use.from_file = found->document().file();
  return use;
}

}  // namespace twinray
