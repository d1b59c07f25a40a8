// SPDX-License-Identifier: Apache-2.0
// Private: from some primitives to an eight-wide tree of them, by way of a binary one.
#pragma once
#include <vector>

#include "accel/accelerator.h"
#include "accel/build/binary_tree.h"
#include "accel/wide/node.h"

namespace twinray {

/// A tree and the box of all that is in it.
template <typename Tree>
struct BoxedBvh {
  Tree bvh;
  Aabb box;
};

/// What the binary tree is built with: leaves that fit into a block, and costs that fill them.
BuildOptions binary_options(BuildOptions options);

/// The tree of some primitives of a geometry. Adds how long each step took to `phases`. Throws Error where
/// the builder is not part of this build.
BoxedBvh<WideBvh> make_tree(const Geometry& geometry, BuildPrimitives primitives, const BuildOptions& options,
                            std::vector<BuildPhase>& phases);

/// The tree of all instances, with leaves of one each.
BoxedBvh<WideBvh> make_instance_tree(const Geometry& geometry, const BuildOptions& options);

}  // namespace twinray
