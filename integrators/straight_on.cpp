// SPDX-License-Identifier: Apache-2.0
#include "integrators/straight_on.h"

#include <cmath>
#include <limits>

#include "integrators/interaction.h"

namespace twinray {

void StraightOn::pass(const Hit& hit, Ray& ray) {
  const Crossing crossing{surface_at(*scene_.geometry, hit), hit.t};
  if (!before_ || !are_one(*before_, crossing, ray.direction))
    interiors_ = Interaction::interiors_behind(scene_, crossing.point, -ray.direction, interiors_);
  before_ = crossing;
  ray.t_min = std::nextafter(hit.t, std::numeric_limits<float>::infinity());
}

bool StraightOn::are_one(const Crossing& a, const Crossing& b, const Vec3& direction) {
  return a.point.shape == b.point.shape && a.point.instance == b.point.instance &&
         (dot(a.point.geometric_normal, direction) > 0) == (dot(b.point.geometric_normal, direction) > 0) &&
         (b.t - a.t) * length(direction) <= a.point.offset + b.point.offset;
}

}  // namespace twinray
