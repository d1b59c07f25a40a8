// SPDX-License-Identifier: Apache-2.0
// Private: the builders of binary trees, ours and Embree's, by the options.
#pragma once
#include "accel/build/binary_tree.h"

namespace twinray {

/// build_tree() by the builder of the options. Throws Error where that is not part of this build.
BuildTree build_by(BuildPrimitives primitives, const BuildOptions& options);

}  // namespace twinray
