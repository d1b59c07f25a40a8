// SPDX-License-Identifier: Apache-2.0
#include "accel/compact/build.h"

#include <utility>

#include "accel/build/phase_timer.h"
#include "accel/compact/partition.h"
#include "accel/wide/forest.h"
#include "accel/wide/layout.h"
#include "accel/wide/tree.h"

namespace twinray {
namespace {

using Phases = std::vector<BuildPhase>;

class CompactBuilder {
 public:
  CompactBuilder(const Geometry& geometry, const BuildOptions& options, std::size_t least)
      : geometry_(geometry), options_(options), least_(least) {}

  BoxedBvh<CompactBvh> build(ShapeRange shapes, Phases& phases) const {
    BuildPrimitives primitives;
    timed("boxes", phases, [&] { primitives = collect_primitives(geometry_, shapes); });
    if (primitives.size() <= least_) return build_part(std::move(primitives), phases);
    Partition parts;
    timed("parts", phases, [&] { parts = partition(primitives, binary_options(options_), least_); });
    std::vector<CompactBvh> trees;
    for (const Partition::Part& part : parts.parts)
      trees.push_back(build_part(take_part(primitives, part), phases).bvh);
    primitives = {};
    BoxedBvh<CompactBvh> made;
    timed("parts", phases, [&] {
      made = {put_together(parts.tree, std::move(trees)), parts.tree.nodes[0].box};
    });
    return made;
  }

 private:
  BoxedBvh<CompactBvh> build_part(BuildPrimitives primitives, Phases& phases) const {
    const BoxedBvh<WideBvh> part = make_tree(geometry_, std::move(primitives), options_, phases);
    BoxedBvh<CompactBvh> made{{}, part.box};
    timed("packing", phases, [&] { made.bvh = CompactBvh(part.bvh); });
    return made;
  }

  /// The tree above parts in front of theirs, of which it names the numbers at first.
  static CompactBvh put_together(const BuildTree& above, std::vector<CompactBvh> parts) {
    CompactBvh all(widen_above(above));
    const std::size_t above_count = all.nodes.size();
    const std::vector<WideRef> roots = append_all(std::move(parts), all, 0);
    for (std::size_t i = 0; i < above_count; ++i)
      for (WideRef& child : all.nodes[i].children)
        if (!child.is_none() && child.is_leaf()) child = roots[child.index()];
    return all;
  }

  const Geometry& geometry_;
  const BuildOptions& options_;
  const std::size_t least_;
};

}  // namespace

CompactBvh make_compact_bvh(const Geometry& geometry, const BuildOptions& options, Phases& phases,
                            std::size_t least) {
  const CompactBuilder builder(geometry, options, least);
  CompactBvh bvh;
  with_threads(options.threads, [&] {
    bvh = make_forest<CompactBvh>(
        geometry, options, [&](ShapeRange shapes, Phases& steps) { return builder.build(shapes, steps); },
        phases);
  });
  return bvh;
}

}  // namespace twinray
