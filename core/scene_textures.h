// SPDX-License-Identifier: Apache-2.0
// What is asked of a scene's textures as a whole.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/texture_model.h"

namespace twinray {

/// Gives all pictures this filter but those of `nearest` pixels, and `bilinear` ones that have no mip-map.
/// In the place of `stochastic`, what has a part in a texture with values outside of [0, 1] gets `trilinear`.
void set_filter(std::span<Texture> textures, TextureFilter filter);

/// Whether any of them is a picture.
bool has_picture(std::span<const Texture> textures);

/// Whether one of the pictures that a texture is made of goes by the second set of coordinates.
bool goes_by_second_uvs(std::span<const Texture> textures, std::uint32_t index);

/// Of each texture, whether it or one that it is made of goes by the point in the scene or the normal there.
std::vector<bool> go_by_position(std::span<const Texture> textures);

/// Whether a texture goes by the surface's texture coordinates, by which of those before it do.
bool goes_by_coordinates(const TextureModel& model, const std::vector<bool>& before);

/// About the mean of a texture over all points, by the means of those that stand before it.
Rgb mean_value(const TextureModel& model, std::span<const Rgb> means);

/// Brings the pictures that a texture is made of into memory as a whole.
void keep_in_memory(std::span<Texture> textures, std::uint32_t index);

/// What a texture may be made of, each part counted as often as it is named: all are evaluated at each hit.
inline constexpr std::uint64_t most_texture_parts = 4096;

/// Throws Error where a texture names one that does not stand before it, has no picture, places what is no
/// pattern, or is made of too many.
void check_textures(std::span<const Texture> textures);

}  // namespace twinray
