// SPDX-License-Identifier: Apache-2.0
// Colours of vertices. Our meshes have none, so they become a picture of the primitive: of each triangle two
// by two texels, between which bilinear filtering is just the mean that barycentric weights give.
#pragma once
#include "core/geometry.h"
#include "io/gltf_material.h"
#include "io/gltf_primitive.h"

namespace twinray {

struct GltfContext;

/// Adds the colours of a primitive's vertices, if it has any, to the use of its material: the same one for
/// all as a constant; else a picture, by whose texture coordinates the mesh goes. A mesh that has some of its
/// own keeps these, and a warning says that its colours are left out.
void add_colors(const GltfPrimitive& primitive, GltfTextures& textures, GltfContext& context, Mesh& mesh,
                GltfUse& use);

}  // namespace twinray
