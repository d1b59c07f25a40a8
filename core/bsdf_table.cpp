// SPDX-License-Identifier: Apache-2.0
#include "core/bsdf_table.h"

#include "core/textured_material.h"

namespace twinray {
namespace {

Bsdf bsdf_of(const SurfaceModel& model, Side side, Materials materials) {
  return Bsdf(materials == Materials::exact ? model : regularized(model), side);
}

}  // namespace

void BsdfAt::look_from(const Vec3& wo) {
  if (!(**this).looks_ahead()) return;
  keep();
  own_->look_from(wo);
}

BsdfTable::BsdfTable(const Scene& scene, Materials materials)
    : scene_(scene), kinds_(materials == Materials::exact ? 2 : 4) {
  made_.reserve(kinds_ * scene.materials.size());
  for (const Material& material : scene.materials)
    for (std::size_t kind = 0; kind < kinds_; ++kind)
      made_.push_back(bsdf_of(material.model, Side(kind % 2), Materials(kind / 2)));
}

BsdfAt BsdfTable::at(std::uint32_t material, const SurfacePoint& point, Side side,
                     const Viewing& viewing) const {
  const Surroundings around =
      viewing.interiors.empty()
          ? Surroundings{}
          : surroundings_of(scene_.materials, material, side == Side::inside, viewing.interiors);
  if (around.is_hidden) return BsdfAt(Bsdf(Interface{}, side));
  const Material& made_of = scene_.materials[material];
  if (made_of.textures.empty() && around.ior == 1)
    return BsdfAt(&made_[kinds_ * material + 2 * std::size_t(viewing.materials) + std::size_t(side)]);
  const SurfaceModel model = textured_model(made_of, scene_.textures, texture_point(point));
  return BsdfAt(bsdf_of(around.ior == 1 ? model : immersed(model, around.ior), side, viewing.materials));
}

}  // namespace twinray
