// SPDX-License-Identifier: Apache-2.0
// Curves as pbrt's Shape statement describes them.
#pragma once
#include "io/diagnostic.h"
#include "io/pbrt/curve.h"
#include "io/pbrt/parameters.h"

namespace twinray {

/// Reads all parameters but "splitdepth". Throws Error at the place of one that is wrong, or of the statement
/// where points or normals are too few or too many.
Curve read_curve_points(const PbrtParameters& parameters, WarningList& warnings);

}  // namespace twinray
