// SPDX-License-Identifier: Apache-2.0
#include "core/bsdf_table.h"

#include "core/surface_model.h"
#include "core/textured_material.h"

namespace twinray {
namespace {

Bsdf bsdf_of(const SurfaceModel& model, Side side, Materials materials) {
  return Bsdf(materials == Materials::exact ? model : regularized(model), side);
}

}  // namespace

BsdfTable::BsdfTable(const Scene& scene) : scene_(scene) {
  made_.reserve(4 * scene.materials.size());
  for (const Material& material : scene.materials)
    for (const Materials materials : {Materials::exact, Materials::regularized})
      for (const Side side : {Side::outside, Side::inside})
        made_.push_back(bsdf_of(material.model, side, materials));
}

Bsdf BsdfTable::at(const SurfacePoint& point, Side side, Materials materials) const {
  const Material& material = material_at(scene_, point);
  if (!material.textures.empty())
    return bsdf_of(textured_model(material, scene_.textures, texture_point(point)), side, materials);
  const auto index = std::size_t(&material - scene_.materials.data());
  return made_[4 * index + 2 * std::size_t(materials) + std::size_t(side)];
}

}  // namespace twinray
