// SPDX-License-Identifier: Apache-2.0
// What surfaces emit by pictures, as pbrt has it.
#pragma once
#include <memory>
#include <span>

#include "core/image.h"
#include "core/light.h"

namespace twinray {

/// The picture of an area light, as it lies over the unit square of its mesh's own texture coordinates: pbrt
/// has no other place for it. One that lies there already is itself; else it is drawn in its own resolution,
/// or a finer one.
std::shared_ptr<const Image> emitted_picture(const MeshLight& light);

/// Whether that shows what the light does: no texture coordinate lies beside the unit square, or the picture
/// goes on there as at its edge.
bool is_emitted_whole(const MeshLight& light, std::span<const Vec2> uvs);

}  // namespace twinray
