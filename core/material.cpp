// SPDX-License-Identifier: Apache-2.0
#include "core/material.h"

#include <algorithm>
#include <utility>

namespace twinray {
namespace {

struct LetsLightIn {
  bool operator()(const Refraction&) const { return true; }
  bool operator()(const Glass&) const { return true; }
  bool operator()(const Interface&) const { return true; }
  bool operator()(const Dielectric& model) const { return !model.is_thin; }
  bool operator()(const Principled& model) const {
    return model.transmission_weight > 0 && model.base_metalness < 1 && !model.geometry_thin_walled;
  }
  template <typename Model>
  bool operator()(const Model&) const {
    return false;
  }
};

}  // namespace

bool lets_light_in(const SurfaceModel& model) { return std::visit(LetsLightIn{}, model); }

bool may_have_subsurface(const SurfaceModel& model) {
  const auto* const principled = std::get_if<Principled>(&model);
  return std::holds_alternative<CoatedDiffuse>(model) || (principled && !principled->geometry_thin_walled);
}

const TextureUse* texture_use(const Material& material, MaterialInput input) {
  const auto found = std::find_if(material.textures.begin(), material.textures.end(),
                                  [=](const TextureUse& use) { return use.input == input; });
  return found == material.textures.end() ? nullptr : &*found;
}

TextureUse* texture_use(Material& material, MaterialInput input) {
  return const_cast<TextureUse*>(texture_use(std::as_const(material), input));
}

bool lets_light_in(const Material& material) {
  const auto* model = std::get_if<Principled>(&material.model);
  if (!model || !texture_use(material, MaterialInput::base_metalness)) return lets_light_in(material.model);
  Principled bare = *model;
  bare.base_metalness = 0;
  return lets_light_in(SurfaceModel(bare));
}

}  // namespace twinray
