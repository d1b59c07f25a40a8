// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "core/lens_system.h"
#include "io/pbrt/context.h"
#include "io/pbrt/parameters.h"

namespace twinray {

/// What the parameters of a realistic camera say of its lens: the surfaces in millimeters, from the scene to
/// the film, with stops as wide as is asked and the film where it has to be. Also reads the file that they
/// name. Warns where the stop cannot be so wide, where there is none, and of what is not rendered as pbrt has
/// it. Throws Error with the place.
std::vector<LensSurface> read_lens(const PbrtParameters& parameters, PbrtContext& context);

/// The lens with all lengths times `scale`, from millimeters to units of the scene; `film_radius` is half of
/// the film's diagonal in millimeters. Throws Error.
LensSystem scaled_lens(std::vector<LensSurface> surfaces, double film_radius, double scale);

}  // namespace twinray
