// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "core/lens_system.h"
#include "io/pbrt/context.h"
#include "io/pbrt/parameters.h"

namespace twinray {

/// What the parameters of a realistic camera say of its lens: the surfaces, from the scene to the film, and
/// the plane in focus.
struct PbrtLens {
  std::vector<LensSurface> surfaces;  ///< In millimeters, as the file has them; a stop as wide as is asked.
  float focus_distance = 10;          ///< From the film, in units of the camera's space.
};

/// Reads them, and the file that they name. Warns where the stop cannot be so wide, and of shapes of the stop
/// that are not rendered. Throws Error with the place.
PbrtLens read_lens(const PbrtParameters& parameters, PbrtContext& context);

/// The lens, with all lengths times `scale` from the camera's space, focused; `film_radius` is half of the
/// film's diagonal, in the scene's units. Throws Error.
LensSystem made_lens(const PbrtLens& lens, double scale, double film_radius);

}  // namespace twinray
