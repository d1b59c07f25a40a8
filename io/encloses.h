// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/geometry.h"

namespace twinray {

/// Whether a point lies within a closed shape: within one of its spheres, or where a slanting ray from it
/// crosses its triangles an odd number of times. What is not closed encloses what it may.
bool encloses(const Shape& shape, const Vec3& point);

}  // namespace twinray
