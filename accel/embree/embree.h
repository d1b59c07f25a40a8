// SPDX-License-Identifier: Apache-2.0
// Private: Embree with our leaf, for tests that want it with a defect.
#pragma once
#include <memory>

#include "accel/accelerator.h"

namespace twinray {

/// The engine `embree` with blocks whose boxes are widened `widening` times as much as accel/embree/bounds.h
/// says. 1 is sound; with 0, boxes that are not widened, Embree loses rays.
std::unique_ptr<Accelerator> build_embree_widened(std::shared_ptr<const Geometry> geometry,
                                                  const BuildOptions& options, float widening);

}  // namespace twinray
