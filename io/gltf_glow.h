// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>
#include <span>

#include "core/geometry.h"
#include "core/image.h"
#include "core/vec.h"
#include "io/gltf_material.h"

namespace twinray {

/// The picture of a surface's light over its mesh's own texture coordinates, as a mesh light takes it: null
/// where these leave the unit square, which such a picture cannot follow.
std::shared_ptr<const Image> glow_over(const GltfSurface& surface, std::span<const Vec2> uvs);

/// Moves the texture coordinates of each triangle by whole numbers, towards the unit square: for surfaces all
/// of whose pictures repeat.
void move_into_square(Mesh& mesh);

}  // namespace twinray
