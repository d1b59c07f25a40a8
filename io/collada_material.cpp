// SPDX-License-Identifier: Apache-2.0
#include "io/collada_material.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/radiance.h"

namespace twinray {
namespace {

constexpr double most_ior = 100;

Rgb required_color(const XmlElement& model, const char* name, float most) {
  return read_color(model.required_child(name), most);
}

float optional_number(const XmlElement& model, const char* name, float fallback, double least, double most) {
  const auto element = model.child(name);
  return element ? float(number_in(*element, least, most)) : fallback;
}

float read_ior(const XmlElement& model) {
  return float(number_in(model.required_child("ior"), 1 / most_ior, most_ior));
}

Microfacet read_microfacet(const XmlElement& model) {
  Microfacet result;
  result.alpha = float(number_in(model.required_child("alpha"), 1e-4, 10));
  result.eta = required_color(model, "eta", float(most_ior));
  result.k = required_color(model, "k", float(most_ior));
  return result;
}

bool is_cgl_model(const XmlElement& element) {
  for (const char* known : {"emission", "mirror", "refraction", "glass", "microfacet"})
    if (element.is(known)) return true;
  return false;
}

/// The first model of a technique; by CS184's rules the last one.
std::optional<XmlElement> cgl_model(const XmlElement& technique, ColladaDocument& document) {
  std::vector<XmlElement> models;
  for (const XmlElement& child : technique.children())
    if (is_cgl_model(child)) models.push_back(child);
  if (models.empty()) return std::nullopt;
  if (document.options().interpretation == Interpretation::cs184)
    std::rotate(models.begin(), models.end() - 1, models.end());
  for (std::size_t i = 1; i < models.size(); ++i)
    document.warn(models[i],
                  fmt::format("this surface is <{}>; a surface has one model, and <{}> is left out",
                              models[0].name(), models[i].name()));
  return models[0];
}

bool has_specular(const XmlElement& shading) {
  const auto specular = shading.child("specular");
  if (!specular) return false;
  const auto color = specular->child("color");
  return color ? !is_black(read_color(*color, max_radiance))
               : specular->child("texture") || specular->child("param");
}

}  // namespace

ColladaMaterial ColladaMaterials::bound(const XmlElement& instance, const std::string& symbol) {
  const auto bind = instance.child("bind_material");
  const auto common = bind ? bind->child("technique_common") : std::nullopt;
  const auto candidates = common ? common->children("instance_material") : std::vector<XmlElement>{};
  for (const XmlElement& candidate : candidates)
    if (symbol.empty() || symbol == candidate.required_attribute("symbol"))
      return once(document_.resolve(candidate, "target", "material"));
  if (const auto named = document_.find(instance, symbol, "material")) {
    document_.warn(instance,
                   fmt::format("no <instance_material> binds the symbol \"{}\"; it is taken to mean the "
                               "<material> with that id",
                               symbol));
    return once(*named);
  }
  if (!symbol.empty())
    document_.warn(
        instance,
        fmt::format("no <instance_material> binds the symbol \"{}\"; the surface is grey (0.5)", symbol));
  return {shared(grey_, "default grey", Lambert{}), {}};
}

ColladaMaterial ColladaMaterials::once(const XmlElement& material) {
  const auto known = known_.find(material);
  return known != known_.end() ? known->second : known_.emplace(material, read(material)).first->second;
}

std::uint32_t ColladaMaterials::black() { return shared(black_, "lamp", Lambert{{0, 0, 0}}); }

std::uint32_t ColladaMaterials::shared(std::uint32_t& index, const std::string& name, const Lambert& model) {
  if (index == none) index = add(name, model).index;
  return index;
}

ColladaMaterial ColladaMaterials::add(const std::string& name, const SurfaceModel& model,
                                      const Rgb& radiance) {
  materials_.push_back({name, model});
  return {std::uint32_t(materials_.size() - 1), radiance};
}

ColladaMaterial ColladaMaterials::read(const XmlElement& material) {
  const std::string name = display_name(material);
  const XmlElement instance = material.required_child("instance_effect");
  const XmlElement effect = document_.resolve(instance, "url", "effect");
  if (const auto technique = cgl_technique(effect))
    if (const auto model = cgl_model(*technique, document_)) return read_cgl(*model, name);
  return read_common(ColladaEffect(effect, instance, document_), name);
}

ColladaMaterial ColladaMaterials::read_cgl(const XmlElement& model, const std::string& name) {
  if (model.is("emission"))
    return add(name, Lambert{{0, 0, 0}}, required_color(model, "radiance", max_radiance));
  if (model.is("mirror")) return add(name, Mirror{required_color(model, "reflectance", 1)});
  if (model.is("microfacet")) return add(name, read_microfacet(model));
  const Rgb transmittance = required_color(model, "transmittance", 1);
  const float roughness = optional_number(model, "roughness", 0, 0, 1);
  if (model.is("refraction")) return add(name, Refraction{transmittance, roughness, read_ior(model)});
  return add(name, Glass{transmittance, required_color(model, "reflectance", 1), roughness, read_ior(model)});
}

ColladaMaterial ColladaMaterials::read_common(const ColladaEffect& effect, const std::string& name) {
  const auto shading = effect.shading();
  if (!shading) {
    document_.warn(effect.element(),
                   "this <effect> has no <phong>, <blinn>, <lambert> or <constant> in its common profile; "
                   "its surfaces are grey (0.5)");
    return add(name, Lambert{});
  }
  const Rgb radiance = read_emission(effect);
  const Rgb reflectance = read_reflectance(effect);
  if (has_specular(*shading)) with_specular_.push_back(name);
  warn_of_transparency(effect);
  warn_of_reflection(effect);
  return add(name, Lambert{reflectance}, radiance);
}

/// Without a diffuse color, what emits reflects nothing; but where a texture says what it emits it is grey,
/// to be seen at all.
Rgb ColladaMaterials::read_reflectance(const ColladaEffect& effect) {
  if (const auto diffuse = effect.slot("diffuse"))
    return color_in(effect, *diffuse, 1, "the surface is grey (0.5)").value_or(Lambert{}.reflectance);
  const auto emission = effect.slot("emission");
  const bool emits = emission ? !emission->child("texture") : effect.shading()->is("constant");
  return emits ? Rgb{0, 0, 0} : Lambert{}.reflectance;
}

Rgb ColladaMaterials::read_emission(const ColladaEffect& effect) {
  const auto emission = effect.slot("emission");
  if (!emission) return {};
  const char* otherwise =
      effect.slot("diffuse") ? "this surface emits nothing" : "this surface is grey (0.5), and emits nothing";
  return color_in(effect, *emission, max_radiance, otherwise).value_or(Rgb{});
}

std::optional<Rgb> ColladaMaterials::color_in(const ColladaEffect& effect, const XmlElement& slot, float most,
                                              const char* otherwise) {
  const auto color = effect.color(slot, most);
  if (!color)
    document_.warn(
        slot, fmt::format("the texture \"{}\" is not rendered; {}", effect.texture_name(slot), otherwise));
  return color;
}

/// What is not rendered may be wrong, too.
void ColladaMaterials::warn_of_transparency(const ColladaEffect& effect) {
  const auto transparent = effect.slot("transparent");
  const auto at = transparent ? transparent : effect.slot("transparency");
  if (!at) return;
  std::optional<double> opacity;
  try {
    opacity = effect.opacity();
  } catch (const Error&) {
    return document_.warn(*at, "the transparency of this surface makes no sense; the surface is opaque");
  }
  if (!opacity)
    document_.warn(
        *at, fmt::format("the texture \"{}\" of the transparency is not rendered; this surface is opaque",
                         effect.texture_name(*at)));
  else if (*opacity != 1)
    document_.warn(*at,
                   fmt::format("transparency is not rendered; this surface is opaque, and the file makes its "
                               "opacity {:.3g}",
                               *opacity));
}

void ColladaMaterials::warn_of_reflection(const ColladaEffect& effect) {
  const auto at = effect.slot("reflective");
  if (!at) return;
  std::optional<double> reflectivity;
  try {
    reflectivity = effect.reflectivity();
  } catch (const Error&) {
    return document_.warn(*at, "the reflection of this surface makes no sense, and is left out");
  }
  if (reflectivity != 0)
    document_.warn(*at,
                   "<reflective> is not rendered; a mirror is a CGL extension in the <extra> of the effect");
}

}  // namespace twinray
