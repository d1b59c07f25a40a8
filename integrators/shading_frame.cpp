// SPDX-License-Identifier: Apache-2.0
#include "integrators/shading_frame.h"

#include "core/shading_map.h"
#include "core/tangents.h"

namespace twinray {
namespace {

/// A shading normal on the viewer's side; the geometric one where the viewer lies behind it.
Vec3 usable(const Vec3& normal, const Vec3& wo, const Vec3& facing_normal) {
  const Vec3 shading = facing(normal, facing_normal);
  return dot(shading, wo) > 0 ? shading : facing_normal;
}

}  // namespace

ShadingFrame shading_frame(const Scene& scene, const Material& material, const SurfacePoint& point,
                           const Vec3& wo) {
  const Vec3 facing_normal = facing(point.geometric_normal, wo);
  const Vec3 normal = has_map(material) ? mapped_normal(scene, material, point) : point.shading_normal;
  const bool is_mapped = normal != point.shading_normal;
  const Vec3 shading = usable(normal, wo, facing_normal);
  if (is_anisotropic(material))
    if (const auto tangents = tangents_at(*scene.geometry, point))
      return {Frame(shading, facet_tangent(scene, material, point, tangents->du)), is_mapped};
  return {Frame(shading), is_mapped};
}

}  // namespace twinray
