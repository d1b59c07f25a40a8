// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/scene.h"
#include "core/surface.h"

namespace twinray {

/// What a surface is made of at a point, as an index into the scene's materials: its shape's; of a Mix, the
/// one of its two that is chosen there. The choice is a hash of the point: the same whenever it is asked for.
std::uint32_t material_at(const Scene& scene, const SurfacePoint& point);

}  // namespace twinray
