// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/image.h"
#include "core/vec.h"

namespace twinray {

/// The radiance of a latitude-longitude picture along a unit direction, bilinear between the pixels' centres.
/// Its rows run from +y to -y, its columns once around: with p = atan2(-z, x) in turns, column (p + 1/2) mod
/// 1 of the width, as CS184's program has it.
Rgb environment_radiance(const Image& map, const Vec3& direction);

}  // namespace twinray
