// SPDX-License-Identifier: Apache-2.0
// What the picture of a light adds up to, by which its "power" or "illuminance" is divided.
#pragma once
#include "core/image.h"
#include "core/light.h"
#include "core/transform.h"

namespace twinray {

/// Of the mean of a pixel's channels over all directions, in steradians.
double sphere_sum(const Image& map, MapLayout layout);

/// What a picture of intensities sends through a frame of this half size, at a distance of 1: the luminance
/// by solid angle.
double frame_sum(const Image& picture, double half_width, double half_height);

/// The illuminance of a plane below a map, as pbrt-v4 takes it: half of what it is. `to_light` turns the
/// map's axes to those of the light, whose z axis points up.
double illuminance_sum(const Image& map, MapLayout layout, const Transform& to_light);

}  // namespace twinray
