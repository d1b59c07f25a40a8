// SPDX-License-Identifier: Apache-2.0
// The filters of FLIP (check/flip.h), by a picture's pixels per degree of the field of view.
#pragma once
#include "core/plane.h"

namespace twinray::flip {

// What the eye passes of each opponent colour.
Plane blurred_brightness(const Plane& plane, double pixels_per_degree);
Plane blurred_red_green(const Plane& plane, double pixels_per_degree);
Plane blurred_yellow_blue(const Plane& plane, double pixels_per_degree);

// How strong an edge, or a point or line, there is in any direction, of brightness from 0 to 1.
Plane edge_strength(const Plane& brightness, double pixels_per_degree);
Plane point_strength(const Plane& brightness, double pixels_per_degree);

}  // namespace twinray::flip
