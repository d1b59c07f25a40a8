// SPDX-License-Identifier: Apache-2.0
#include "integrators/interaction.h"

namespace twinray {
namespace {

/// The normal, or its opposite, on the side of another vector.
Vec3 facing(const Vec3& normal, const Vec3& side) { return dot(normal, side) < 0 ? -normal : normal; }

Vec3 usable_shading_normal(const SurfacePoint& point, const Vec3& wo, const Vec3& facing_normal) {
  const Vec3 shading = facing(point.shading_normal, facing_normal);
  return dot(shading, wo) > 0 ? shading : facing_normal;
}

Side side_of(const SurfacePoint& point, const Vec3& wo) {
  const bool is_before = dot(point.geometric_normal, wo) > 0;
  const bool points_outside = dot(point.geometric_normal, point.shading_normal) >= 0;
  return is_before == points_outside ? Side::outside : Side::inside;
}

}  // namespace

Interaction::Interaction(const BsdfTable& bsdfs, const SurfacePoint& point, const Vec3& wo,
                         Materials materials)
    : point_(point),
      wo_(wo),
      facing_normal_(facing(point.geometric_normal, wo)),
      frame_(usable_shading_normal(point, wo, facing_normal_)),
      wo_local_(frame_.to_local(wo)),
      bsdf_(bsdfs.at(point, side_of(point, wo), materials)) {}

}  // namespace twinray
