// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/material.h"

namespace twinray {

/// How materials scatter: as the scene says, or so rough that light samples find it.
enum class Materials { exact, regularized };

/// The model with a roughness of at least 0.1, and doubled up to 0.3, mirrors and smooth glass too: so rough
/// that samples of lights find what it scatters. Diffuse models, thin sheets and surfaces that only refract
/// stay as they are. pbrt-v4 regularizes so (Pharr, Jakob and Humphreys 2023).
SurfaceModel regularized(const SurfaceModel& model);

}  // namespace twinray
