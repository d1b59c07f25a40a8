// SPDX-License-Identifier: Apache-2.0
#include "accel/wide/build.h"

#include "accel/build/phase_timer.h"
#include "accel/builders.h"
#include "accel/wide/forest.h"

namespace twinray {

WideBvh make_wide_bvh(const Geometry& geometry, const BuildOptions& options,
                      std::vector<BuildPhase>& phases) {
  const TreeMaker<WideBvh> make = [&](ShapeRange shapes, std::vector<BuildPhase>& steps) {
    BuildPrimitives primitives;
    timed("boxes", steps, [&] { primitives = collect_primitives(geometry, shapes); });
    return make_tree(geometry, std::move(primitives), options, steps);
  };
  WideBvh bvh;
  with_threads(options.threads, [&] { bvh = make_forest(geometry, options, make, phases); });
  return bvh;
}

}  // namespace twinray
