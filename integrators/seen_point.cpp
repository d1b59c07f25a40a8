// SPDX-License-Identifier: Apache-2.0
#include "integrators/seen_point.h"

namespace twinray {

SurfacePoint seen_point(const Scene& scene, const Hit& hit, const Vec3& direction,
                        const VertexSampler& sampler, RayCone& cone) {
  SurfacePoint point = surface_at(*scene.geometry, hit);
  if (scene.textures.empty()) return point;
  cone = cone.at(hit.t * length(direction));
  const auto footprint = [&](CoordinateSet set) {
    return texture_footprint(*scene.geometry, hit, point, cone.width, direction, set);
  };
  point.footprint = footprint(CoordinateSet::first);
  point.second_footprint = footprint(CoordinateSet::second);
  point.width = section_width(point, cone.width, direction);
  point.texture_draw = sampler.draw_2d(Purpose::texture);
  return point;
}

}  // namespace twinray
