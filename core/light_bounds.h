// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/geometry.h"
#include "core/light.h"
#include "core/light_tree.h"

namespace twinray {

/// What a light tree knows of a light that has a place: a mesh, a sphere, or a kind of point light.
LightBounds bounds_of(const LightSource& source, const Geometry& geometry);

}  // namespace twinray
