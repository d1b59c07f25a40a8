// SPDX-License-Identifier: Apache-2.0
// Colours of vertices. Our meshes have none, so they become a picture of the mesh: of each triangle two by
// two texels, between which bilinear filtering is just the mean that barycentric weights give.
#pragma once
#include <cstdint>
#include <functional>
#include <span>

#include "core/geometry.h"
#include "core/texture.h"

namespace twinray {

/// Whether a mesh is small enough for such a picture (io/picture/picture_meaning.h).
bool can_draw_vertices(const Mesh& mesh);

/// The picture of what vertices have, by the numbers of their positions.
ImageTexture draw_vertices(const Mesh& mesh, const std::function<Rgb(std::uint32_t)>& value);

/// Whether a texture, or one that it is made of, is such a picture: then the surface has the coordinates of
/// its mesh's.
bool is_drawn_of_vertices(std::span<const Texture> textures, std::uint32_t texture);

/// Gives a mesh the texture coordinates of such pictures of it, in place of its own; or as its second ones.
void set_drawn_uvs(Mesh& mesh, CoordinateSet set = CoordinateSet::first);

}  // namespace twinray
