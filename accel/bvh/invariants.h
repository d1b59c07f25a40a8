// SPDX-License-Identifier: Apache-2.0
// Private: what is true of every finished binary tree, for the tests.
#pragma once
#include <string>

#include "accel/build/coverage.h"
#include "accel/bvh/node.h"
#include "core/geometry.h"

namespace twinray {

/// What is wrong with a tree over a geometry, in one sentence; empty where all holds: every primitive, with
/// the widening of padded(), lies in leaves as often as it should, no leaf holds more than max_leaf_size,
/// each box contains those of its children, and no leaf is deeper than max_bvh_depth.
std::string find_fault(const Bvh& bvh, const Geometry& geometry, int max_leaf_size,
                       Occurrence occurrence = Occurrence::once);

}  // namespace twinray
