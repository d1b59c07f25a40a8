// SPDX-License-Identifier: Apache-2.0
#include "io/collada/material.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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

/// The element of an <instance_material> that binds a set of texture coordinates to a name.
std::optional<XmlElement> uv_bind_of(const XmlElement& instance, const std::string& texcoord) {
  for (const XmlElement& bind : instance.children("bind_vertex_input"))
    if (bind.attribute("semantic") == texcoord &&
        bind.attribute("input_semantic").value_or("TEXCOORD") == "TEXCOORD")
      return bind;
  return std::nullopt;
}

bool has_specular(const XmlElement& shading) {
  const auto specular = shading.child("specular");
  if (!specular) return false;
  const auto color = specular->child("color");
  return color ? !is_black(read_color(*color, max_radiance))
               : specular->child("texture") || specular->child("param");
}

}  // namespace

ColladaBinding ColladaMaterials::bound(const XmlElement& instance, const std::string& symbol) {
  const auto bind = instance.child("bind_material");
  const auto common = bind ? bind->child("technique_common") : std::nullopt;
  const auto candidates = common ? common->children("instance_material") : std::vector<XmlElement>{};
  for (const XmlElement& candidate : candidates)
    if (symbol.empty() || symbol == candidate.required_attribute("symbol")) {
      const ColladaMaterial material = once(document_.resolve(candidate, "target", "material"));
      const auto set = uv_bind_of(candidate, material.texcoord);
      if (!set) return {material, {}, {}};
      return {material, set->index_attribute("input_set", 0), set};
    }
  if (const auto named = document_.find(instance, symbol, "material")) {
    document_.warn(instance,
                   fmt::format("no <instance_material> binds the symbol \"{}\"; it is taken to mean the "
                               "<material> with that id",
                               symbol));
    return {once(*named), {}, {}};
  }
  if (!symbol.empty())
    document_.warn(
        instance,
        fmt::format("no <instance_material> binds the symbol \"{}\"; the surface is grey (0.5)", symbol));
  return {{.index = shared(grey_, "default grey", Lambert{})}, {}, {}};
}

ColladaMaterial ColladaMaterials::once(const XmlElement& material) {
  const auto known = known_.find(material);
  return known != known_.end() ? known->second : known_.emplace(material, read(material)).first->second;
}

std::uint32_t ColladaMaterials::black() { return shared(black_, "lamp", Lambert{{0, 0, 0}}); }

std::uint32_t ColladaMaterials::shared(std::uint32_t& index, const std::string& name, const Lambert& model) {
  if (index == none) index = add({name, model}).index;
  return index;
}

ColladaMaterial ColladaMaterials::add(Material material, const Rgb& radiance) {
  materials_.push_back(std::move(material));
  return {.index = std::uint32_t(materials_.size() - 1), .glow = {.radiance = radiance}};
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
    return add({name, Lambert{{0, 0, 0}}}, required_color(model, "radiance", max_radiance));
  if (model.is("mirror")) return add({name, Mirror{required_color(model, "reflectance", 1)}});
  if (model.is("microfacet")) return add({name, read_microfacet(model)});
  const Rgb transmittance = required_color(model, "transmittance", 1);
  const float roughness = optional_number(model, "roughness", 0, 0, 1);
  if (model.is("refraction")) return add({name, Refraction{transmittance, roughness, read_ior(model)}});
  return add(
      {name, Glass{transmittance, required_color(model, "reflectance", 1), roughness, read_ior(model)}});
}

ColladaMaterial ColladaMaterials::read_common(const ColladaEffect& effect, const std::string& name) {
  const auto shading = effect.shading();
  if (!shading) {
    document_.warn(effect.element(),
                   "this <effect> has no <phong>, <blinn>, <lambert> or <constant> in its common profile; "
                   "its surfaces are grey (0.5)");
    return add({name, Lambert{}});
  }
  Material material{name, Lambert{}};
  ColladaMaterial made;
  read_emission(effect, made);
  read_diffuse(effect, material, made);
  if (has_specular(*shading)) with_specular_.push_back(name);
  read_transparency(effect, made);
  warn_of_reflection(effect);
  made.index = add(std::move(material)).index;
  return made;
}

std::uint32_t ColladaMaterials::texture_in(const ColladaEffect& effect, const XmlElement& slot,
                                           const PictureMeaning& meaning, const char* otherwise,
                                           ColladaMaterial& made) {
  const auto use = effect.texture(slot);
  const bool is_cs184 = document_.options().interpretation == Interpretation::cs184;
  if (!use || use->from_file.empty() || is_cs184) {
    document_.warn(slot, fmt::format("the texture \"{}\" {}; {}", use ? use->name : "",
                                     is_cs184 ? "is not rendered" : "leads to no <image>", otherwise));
    return no_texture;
  }
  const std::uint32_t texture = textures_.picture(*use, meaning);
  if (made.is_textured && made.texcoord != use->texcoord)
    document_.warn(use->element,
                   fmt::format("the textures of a surface have one set of texture coordinates here: \"{}\", "
                               "and not \"{}\"",
                               made.texcoord, use->texcoord));
  if (!made.is_textured) made.texcoord = use->texcoord;
  made.is_textured = true;
  return texture;
}

/// Without a diffuse color, what emits reflects nothing; but where a texture that cannot be used says what it
/// emits it is grey, to be seen at all.
void ColladaMaterials::read_diffuse(const ColladaEffect& effect, Material& material, ColladaMaterial& made) {
  auto& [reflectance] = std::get<Lambert>(material.model);
  const auto diffuse = effect.slot("diffuse");
  if (!diffuse) {
    const auto emission = effect.slot("emission");
    const bool emits =
        emission ? !emission->child("texture") || made.glow.picture : effect.shading()->is("constant");
    if (emits) reflectance = {0, 0, 0};
    return;
  }
  if (const auto color = effect.color(*diffuse, 1)) {
    reflectance = *color;
    return;
  }
  const std::uint32_t texture = texture_in(effect, *diffuse, {PictureRole::color, PictureChannels::color},
                                           "the surface is grey (0.5)", made);
  if (texture != no_texture) material.textures.push_back({MaterialInput::reflectance, texture});
}

void ColladaMaterials::read_emission(const ColladaEffect& effect, ColladaMaterial& made) {
  const auto emission = effect.slot("emission");
  if (!emission) return;
  if (const auto color = effect.color(*emission, max_radiance)) {
    made.glow.radiance = *color;
    return;
  }
  const char* otherwise =
      effect.slot("diffuse") ? "this surface emits nothing" : "this surface is grey (0.5), and emits nothing";
  const std::uint32_t texture =
      texture_in(effect, *emission, {PictureRole::color, PictureChannels::color}, otherwise, made);
  if (texture == no_texture || textures_.is_faulty(texture)) return;
  const auto& picture = std::get<ImageTexture>(textures_.textures[texture].model);
  made.glow.radiance = {1, 1, 1};
  made.glow.picture = std::make_shared<const Image>(picture.image->image(0));
  made.glow.uv = picture.uv;
  made.glow.wrap = picture.wrap;
  if (picture.filter == TextureFilter::nearest) made.glow.filter = TextureFilter::nearest;
}

/// A texture cuts holes. An even transparency is meant in as many ways as there are programs that write it:
/// it is not rendered, and may be wrong, too.
void ColladaMaterials::read_transparency(const ColladaEffect& effect, ColladaMaterial& made) {
  const auto transparent = effect.slot("transparent");
  const auto at = transparent ? transparent : effect.slot("transparency");
  if (!at) return;
  std::optional<double> opacity;
  std::string mode;
  double amount = 1;
  try {
    opacity = effect.opacity();
    mode = effect.opaque_mode();
    amount = std::clamp(effect.transparency(), 0.0, 1.0);
  } catch (const Error&) {
    return document_.warn(*at, "the transparency of this surface makes no sense; the surface is opaque");
  }
  if (!opacity) return add_holes(effect, *at, mode, float(amount), made);
  if (*opacity != 1)
    document_.warn(*at,
                   fmt::format("transparency is not rendered; this surface is opaque, and the file makes its "
                               "opacity {:.3g}",
                               *opacity));
}

void ColladaMaterials::add_holes(const ColladaEffect& effect, const XmlElement& slot, const std::string& mode,
                                 float amount, ColladaMaterial& made) {
  const PictureChannels channels = mode[0] == 'A' ? PictureChannels::alpha : PictureChannels::brightness;
  const std::uint32_t texture =
      texture_in(effect, slot, {PictureRole::data, channels}, "this surface is opaque", made);
  if (texture == no_texture || textures_.is_faulty(texture)) return;
  const float at_0 = mode.ends_with("ONE") ? 0.0f : 1.0f, at_1 = std::fabs(at_0 - amount);
  if (at_1 == 1 && textures_.is_one(texture)) return;
  const std::uint32_t first = textures_.constant(at_0), second = textures_.constant(at_1);
  made.alpha = textures_.add(MixTexture{first, second, texture});
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
