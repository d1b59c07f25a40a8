// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/material.h"
#include "io/pbrt/material_inputs.h"

namespace twinray {

/// pbrt's "subsurface": a coat on a base, and what is below it. By the absorption and scattering of the body,
/// by the name of a measured one, or by how much of the light that has entered comes out again.
SurfaceModel read_subsurface(const PbrtMaterialInputs& in, Subsurface& below);

/// What OpenPBR's surface has below it.
Subsurface read_principled_subsurface(const PbrtMaterialInputs& in, const Principled& model);

}  // namespace twinray
