// SPDX-License-Identifier: Apache-2.0
// Crosschecks of geometry made in code.
#pragma once
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "check/crosscheck.h"
#include "check/placement.h"
#include "check/shape_rays.h"

namespace twinray::test {

/// All ray classes that are made from shapes.
inline std::vector<RayClass> shape_ray_classes() {
  std::vector<RayClass> classes;
  for (std::size_t i = std::size_t(RayClass::random); i < ray_class_count; ++i)
    classes.push_back(RayClass(i));
  return classes;
}

/// Builds one engine over a geometry.
struct EngineMaker {
  std::string name;
  std::unique_ptr<Accelerator> (*make)(std::shared_ptr<const Geometry>);
  bool is_canonical = true;
  std::uint64_t every = 1;
};

/// `count` rays of each class of the same placement through all engines, the first of which is the reference.
inline void check_placement(const std::shared_ptr<const Geometry>& file, Placement placement,
                            const std::vector<EngineMaker>& makers, std::uint64_t count,
                            CrosscheckReport& report) {
  const auto geometry = placed_geometry(file, placement);
  std::vector<std::unique_ptr<Accelerator>> owned;
  std::vector<CheckedEngine> engines;
  for (const EngineMaker& maker : makers) {
    owned.push_back(maker.make(geometry));
    engines.push_back({maker.name, owned.back().get(), maker.is_canonical, maker.every});
  }
  const Crosscheck crosscheck(geometry, engines);
  const ShapeRays rays(geometry, *owned.front(), 7);
  for (const RayClass ray_class : shape_ray_classes())
    if (placement_of(ray_class) == placement)
      for (std::uint64_t i = 0; i < count; ++i)
        crosscheck.check(rays.ray(ray_class, i), ray_class, i, report);
}

/// The same at all placements.
inline CrosscheckReport crosscheck(const std::shared_ptr<const Geometry>& geometry,
                                   const std::vector<EngineMaker>& makers, std::uint64_t count) {
  CrosscheckReport report(makers.size());
  for (const Placement placement : {Placement::file, Placement::moved, Placement::shrunk, Placement::grown})
    check_placement(geometry, placement, makers, count, report);
  return report;
}

}  // namespace twinray::test
