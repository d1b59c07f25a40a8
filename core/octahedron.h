// SPDX-License-Identifier: Apache-2.0
// Unit vectors as two numbers: the octahedral map (Meyer et al., "On Floating-Point Normal Vectors", 2010).
#pragma once
#include "core/vec.h"

namespace twinray {

/// The unit vector of (u, v) in [0, 1]^2.
Vec3 octahedral_decode(float u, float v);
/// The (u, v) of a direction of any length but 0, given in double.
Vec2 octahedral_encode(double x, double y, double z);

}  // namespace twinray
