// SPDX-License-Identifier: Apache-2.0
#include "io/collada_material.h"

#include <fmt/format.h>

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

std::optional<XmlElement> shading_of(const XmlElement& effect) {
  const auto profile = effect.child("profile_COMMON");
  const auto technique = profile ? profile->child("technique") : std::nullopt;
  if (!technique) return std::nullopt;
  for (const char* name : {"phong", "blinn", "lambert", "constant"})
    if (const auto shading = technique->child(name)) return shading;
  return std::nullopt;
}

/// The <newparam sid> of an effect, or of its profile, or of its technique.
std::optional<XmlElement> find_param(const XmlElement& element, const std::string& sid) {
  for (const XmlElement& child : element.children()) {
    if (child.is("newparam") && child.attribute("sid") == sid) return child;
    if (child.is("profile_COMMON") || child.is("technique"))
      if (const auto found = find_param(child, sid)) return found;
  }
  return std::nullopt;
}

bool has_specular(const XmlElement& shading) {
  const auto specular = shading.child("specular");
  const auto color = specular ? specular->child("color") : std::nullopt;
  return color && !is_black(read_color(*color, max_radiance));
}

}  // namespace

ColladaMaterial ColladaMaterials::bound(const XmlElement& instance, const std::string& symbol) {
  const auto bind = instance.child("bind_material");
  const auto common = bind ? bind->child("technique_common") : std::nullopt;
  const auto candidates = common ? common->children("instance_material") : std::vector<XmlElement>{};
  for (const XmlElement& candidate : candidates) {
    const std::string bound_symbol = candidate.required_attribute("symbol");
    if (symbol.empty() || symbol == bound_symbol) {
      const XmlElement material = document_.resolve(candidate, "target", "material");
      const auto known = known_.find(material);
      return known != known_.end() ? known->second : known_.emplace(material, read(material)).first->second;
    }
  }
  if (!symbol.empty())
    document_.warn(
        instance,
        fmt::format("no <instance_material> binds the symbol \"{}\"; the surface is grey (0.5)", symbol));
  return {shared(grey_, "default grey", Lambert{}), {}};
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
  const XmlElement effect = document_.resolve(material.required_child("instance_effect"), "url", "effect");
  if (const auto technique = cgl_technique(effect))
    for (const XmlElement& model : technique->children())
      for (const char* known : {"emission", "mirror", "refraction", "glass", "microfacet"})
        if (model.is(known)) return read_cgl(model, name);
  return read_common(effect, name);
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

ColladaMaterial ColladaMaterials::read_common(const XmlElement& effect, const std::string& name) {
  const auto shading = shading_of(effect);
  if (!shading) {
    document_.warn(effect,
                   "this <effect> has no <phong>, <blinn>, <lambert> or <constant> in its common profile; "
                   "its surfaces are grey (0.5)");
    return add(name, Lambert{});
  }
  const auto diffuse = shading->child("diffuse"), emission = shading->child("emission");
  Lambert model;
  if (diffuse) model.reflectance = read_shading_color(effect, *diffuse, 1);
  if (!diffuse && (emission || shading->is("constant"))) model.reflectance = {0, 0, 0};
  Rgb radiance;
  if (emission && !emission->child("texture")) radiance = read_shading_color(effect, *emission, max_radiance);
  if (emission && emission->child("texture"))
    document_.warn(*emission, "textures are not read; this surface emits nothing");
  if (has_specular(*shading)) with_specular_.push_back(name);
  return add(name, model, radiance);
}

Rgb ColladaMaterials::read_shading_color(const XmlElement& effect, const XmlElement& slot, float most) {
  if (const auto color = slot.child("color")) return read_color(*color, most);
  if (const auto param = slot.child("param")) {
    const auto definition = find_param(effect, param->required_attribute("ref"));
    for (const char* type : {"float3", "float4"})
      if (const auto value = definition ? definition->child(type) : std::nullopt)
        return read_color(*value, most);
    throw error_at(param->attribute_place("ref"),
                   "no <newparam> of this effect with this sid has a <float3> or <float4>");
  }
  if (!slot.child("texture"))
    slot.fail(fmt::format("<{}> needs a <color>, a <param> or a <texture>", slot.name()));
  document_.warn(slot, "textures are not read; the surface is grey (0.5)");
  return Lambert{}.reflectance;
}

}  // namespace twinray
