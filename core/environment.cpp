// SPDX-License-Identifier: Apache-2.0
#include "core/environment.h"

#include <algorithm>
#include <cmath>

#include "core/elementary.h"
#include "core/radiance.h"

namespace twinray {

Rgb environment_radiance(const Image& map, const Vec3& direction) {
  const double polar =
      atan2_turns(std::sqrt(double(direction.x) * direction.x + double(direction.z) * direction.z),
                  direction.y);  // 0 at +y, 1/2 at -y
  const double around = atan2_turns(-direction.z, direction.x) + 0.5;
  const double column = around * map.width - 0.5, row = polar * 2 * map.height - 0.5;
  const double left = std::floor(column), above = std::floor(row);
  const auto s = float(column - left), t = float(row - above);
  const auto at = [&](int dx, int dy) {
    const int x = (int(left) + dx + map.width) % map.width;
    return map.at(x, std::clamp(int(above) + dy, 0, map.height - 1));
  };
  const Rgb upper = at(0, 0) * (1 - s) + at(1, 0) * s;
  const Rgb lower = at(0, 1) * (1 - s) + at(1, 1) * s;
  const Rgb radiance = upper * (1 - t) + lower * t;
  // The weights' sum is rounded: between two pixels of the greatest radiance it could exceed it.
  return {std::min(radiance.r, max_radiance), std::min(radiance.g, max_radiance),
          std::min(radiance.b, max_radiance)};
}

}  // namespace twinray
