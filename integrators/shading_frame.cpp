// SPDX-License-Identifier: Apache-2.0
#include "integrators/shading_frame.h"

#include <algorithm>
#include <variant>

#include "core/shading_map.h"
#include "core/tangents.h"

namespace twinray {
namespace {

/// A shading normal on the viewer's side; the geometric one where the viewer lies behind it.
Vec3 usable(const Vec3& normal, const Vec3& wo, const Vec3& facing_normal) {
  const Vec3 shading = facing(normal, facing_normal);
  return dot(shading, wo) > 0 ? shading : facing_normal;
}

/// Whether it reflects into a direction or around one.
bool is_glossy(const Material& material) {
  return !std::holds_alternative<Lambert>(material.model) &&
         !std::holds_alternative<RoughDiffuse>(material.model) &&
         !std::holds_alternative<Hair>(material.model) &&
         !std::holds_alternative<DiffuseTransmission>(material.model);
}

/// A normal by which a mirror does not reflect to below the true surface, where its reflection would be
/// black: one that leans less where the given one does (Keller et al., "The Iray Light Transport Simulation
/// and Rendering System", 2017, bend the reflection likewise). Both lie on the viewer's side.
Vec3 bent(const Vec3& normal, const Vec3& wo, const Vec3& facing_normal) {
  // The least cosine of a reflection: a grazing one where the viewer looks from further up.
  const float least = std::min(0.9f * dot(facing_normal, wo), 0.01f);
  const Vec3 reflected = normal * (2 * dot(normal, wo)) - wo;
  const float cosine = dot(reflected, facing_normal);
  if (!(cosine < least)) return normal;
  return normalize(wo + normalize(reflected + facing_normal * (least - cosine)));
}

}  // namespace

ShadingFrame shading_frame(const Scene& scene, const Material& material, const SurfacePoint& point,
                           const Vec3& wo) {
  const Vec3 facing_normal = facing(point.geometric_normal, wo);
  const Vec3 normal = has_map(material) ? mapped_normal(scene, material, point) : point.shading_normal;
  const bool is_mapped = normal != point.shading_normal;
  const Vec3 seen = usable(normal, wo, facing_normal);
  const Vec3 shading = is_glossy(material) ? bent(seen, wo, facing_normal) : seen;
  if (is_anisotropic(material))
    if (const auto tangents = tangents_at(*scene.geometry, point))
      return {Frame(shading, facet_tangent(scene, material, point, tangents->du)), is_mapped};
  return {Frame(shading), is_mapped};
}

}  // namespace twinray
