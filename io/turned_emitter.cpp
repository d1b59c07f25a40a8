// SPDX-License-Identifier: Apache-2.0
#include "io/turned_emitter.h"

#include <variant>

namespace twinray {
namespace {

/// Whether a material scatters otherwise, or leads elsewhere, on its inside than on its outside.
bool has_inside(const Scene& scene, std::uint32_t index) {
  const Material& material = scene.materials[index];
  if (has_interior(material)) return true;
  if (const auto* mix = std::get_if<Mix>(&material.model))
    return has_inside(scene, mix->first) || has_inside(scene, mix->second);
  const auto* boundary = std::get_if<Dielectric>(&material.model);
  return (boundary && !boundary->is_thin) || std::holds_alternative<Glass>(material.model) ||
         std::holds_alternative<Refraction>(material.model) ||
         std::holds_alternative<Principled>(material.model) ||
         std::holds_alternative<Measured>(material.model);
}

}  // namespace

void name_turned_emitter(const Scene& scene, const MeshLight& light, Losses& losses) {
  if (light.side != EmissionSide::back || !has_inside(scene, scene.bindings[light.shape].material)) return;
  losses.add("a surface whose back emits is turned around, so that its outside is within",
             "{} surfaces whose backs emit are turned around, so that their outsides are within");
}

}  // namespace twinray
