// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/aabb.h"
#include "core/camera.h"

namespace twinray {

/// A camera that sees the whole box in three-quarter view: its front (+Z), its right side and its top, with a
/// field of 40 degrees.
Camera default_camera(const Aabb& bounds);

}  // namespace twinray
