// SPDX-License-Identifier: Apache-2.0
#include "check/ceilings.h"

namespace twinray {
namespace {

/// `parts` of a million, rounded up.
std::uint64_t millionths(std::uint64_t rays, std::uint64_t parts) {
  return (rays * parts + 999999) / 1000000;
}

}  // namespace

std::optional<Ceiling> ceiling_of(RayClass ray_class, std::uint64_t rays) {
  switch (ray_class) {
    case RayClass::camera:
    case RayClass::bounce:
    case RayClass::random:
      return Ceiling{Ceiling::Counts::odd, millionths(rays, 100)};
    case RayClass::edges:
      return Ceiling{Ceiling::Counts::leaks, 0};
    case RayClass::vertices:
      return Ceiling{Ceiling::Counts::leaks, millionths(rays, 5000)};
    default:
      return std::nullopt;
  }
}

std::vector<PassedCeiling> passed_ceilings(const CrosscheckReport& report) {
  std::vector<PassedCeiling> passed;
  for (std::size_t engine = 0; engine < report.engine_count(); ++engine)
    for (std::size_t i = 0; i < ray_class_count; ++i) {
      const Tally& tally = report.tally(engine, RayClass(i));
      const std::optional<Ceiling> ceiling = ceiling_of(RayClass(i), tally.rays);
      if (!ceiling) continue;
      const std::uint64_t found = ceiling->counts == Ceiling::Counts::odd ? tally.odd() : tally.leaks;
      if (found > ceiling->most) passed.push_back({engine, RayClass(i), *ceiling, found});
    }
  return passed;
}

}  // namespace twinray
