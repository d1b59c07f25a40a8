// SPDX-License-Identifier: Apache-2.0
// What an <asset> says of the coordinates within its parent element: their unit and the axis that points up.
#pragma once
#include <string>

#include "core/transform.h"
#include "io/diagnostic.h"
#include "io/xml/reader.h"

namespace twinray {

struct ColladaSpace {
  std::string unit_name = "meter";
  double unit_meters = 1;  ///< > 0.
  char up_axis = 'Y';      ///< X, Y or Z.
};

/// What an <asset> says; what it leaves out is as outside. A unit with a decimal comma and an empty axis are
/// warnings. Throws Error for an unknown axis and for a unit
/// that is not above 0.
ColladaSpace read_space(const XmlElement& asset, const ColladaSpace& outside, WarningList& warnings);

/// Coordinates of one space in those of another one: scaled by their units and turned by their axes, as
/// COLLADA has these (right, up and towards the viewer: X_UP -y, x, z; Y_UP x, y, z; Z_UP x, z, -y).
Transform conversion(const ColladaSpace& from, const ColladaSpace& to);

/// The turn that brings an up axis to Y as CS184's program has it: Z_UP (x, y, z) -> (-x, z, y), X_UP (x, y,
/// z) -> (y, x, -z). It is COLLADA's and half a turn about Y.
Transform turn_to_y_up(char up_axis);

}  // namespace twinray
