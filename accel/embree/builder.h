// SPDX-License-Identifier: Apache-2.0
// Private: Embree's builders as makers of our own tree.
#pragma once
#include <vector>

#include "accel/build/binary_tree.h"

namespace twinray {

/// The binary tree that Embree's builder (options.bvh_builder, which must not be `own`) makes of the
/// primitives, with its maximum leaf size and costs; its split method and bins do not apply. Our layout and
/// counting traversal then serve it like any tree of ours. That of embree_high holds pieces of primitives, up
/// to twice as many as there are primitives; no leaf holds two of the same. Built on one thread, because the
/// order of primitives inside of Embree depends on how many there are. Throws Error where Embree reports one.
BuildTree build_tree_by_embree(BuildPrimitives primitives, const BuildOptions& options);

}  // namespace twinray
