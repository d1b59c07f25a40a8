// SPDX-License-Identifier: Apache-2.0
// Colours, or numbers, that differ over a surface: plain values, linked by index. A texture may name others
// that stand before it in Scene::textures.
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <variant>

#include "core/coordinate_set.h"
#include "core/mip_map.h"
#include "core/rgb.h"
#include "core/vec.h"

namespace twinray {

/// What lies beside a picture: the picture again, its outermost pixels, nothing.
enum class WrapMode { repeat, clamp, black };

/// To the sides of a picture along u, and above and below it along v.
struct Wrap {
  WrapMode u = WrapMode::repeat, v = WrapMode::repeat;

  constexpr Wrap() = default;
  constexpr Wrap(WrapMode both) : u(both), v(both) {}
  constexpr Wrap(WrapMode in_u, WrapMode in_v) : u(in_u), v(in_v) {}
  friend bool operator==(const Wrap&, const Wrap&) = default;
};

/// How a value between pixels is made. Of the picture itself: the nearest one; bilinear of the four around.
/// Of the two levels of the mip-map whose pixels are about as large as the footprint: trilinear of the eight
/// around; or one of these at random, whose mean is trilinear's (Fajardo et al., "Stochastic Texture
/// Filtering", 2023).
enum class TextureFilter { nearest, bilinear, trilinear, stochastic };

/// An affine map of texture coordinates: u' = m[0] . (u, v, 1), v' = m[1] . (u, v, 1).
struct UvTransform {
  float m[2][3] = {{1, 0, 0}, {0, 1, 0}};

  Vec2 operator()(Vec2 uv) const {
    return {m[0][0] * uv.x + m[0][1] * uv.y + m[0][2], m[1][0] * uv.x + m[1][1] * uv.y + m[1][2]};
  }
  friend bool operator==(const UvTransform&, const UvTransform&) = default;
};

/// The same everywhere.
struct ConstantTexture {
  Rgb value{1, 1, 1};
};

/// A picture: u runs to the right, v upwards, (0, 0) is its lower left corner, (1, 1) its upper right one.
struct ImageTexture {
  std::shared_ptr<const MipMap> image;  ///< Never null. Linear values.
  Wrap wrap;
  TextureFilter filter = TextureFilter::stochastic;
  UvTransform uv;
  CoordinateSet coordinates = CoordinateSet::first;  ///< Those that `uv` maps.
};

/// The product of two textures.
struct ScaleTexture {
  std::uint32_t first = 0, second = 0;
};

/// (1 - amount) first + amount second; the amount is a texture's red.
struct MixTexture {
  std::uint32_t first = 0, second = 0, amount = 0;
};

/// Squares of side 1 of the transformed coordinates, like a chess board: the first has (0, 0) at its corner.
struct CheckerboardTexture {
  std::uint32_t first = 0, second = 0;
  UvTransform uv;
};

using TextureModel =
    std::variant<ConstantTexture, ImageTexture, ScaleTexture, MixTexture, CheckerboardTexture>;

struct Texture {
  std::string name;
  TextureModel model;
};

/// Where a texture is asked for.
struct TexturePoint {
  Vec2 uv;
  float footprint = 0;  ///< The width, in texture coordinates, of what one sample sees; 0: a point.
  /// In [0, 1)^2: chooses the pixels of stochastic filters, the same for all textures of a surface. So one
  /// point of the surface is shaded, and the mean over the draws is that of shaded points.
  Vec2 draw{0.5f, 0.5f};
  bool is_smooth = false;  ///< Stochastic filters are trilinear here: for normals, heights and holes.
  Vec2 second_uv;          ///< By the second set of coordinates, for pictures that go by it.
  float second_footprint = 0;
};

/// Gives all pictures this filter but those of `nearest` pixels, and `bilinear` ones that have no mip-map.
/// In the place of `stochastic`, what has a part in a texture with values outside of [0, 1] gets `trilinear`.
void set_filter(std::span<Texture> textures, TextureFilter filter);

/// Whether any of them is a picture.
bool has_picture(std::span<const Texture> textures);

/// Whether one of the pictures that a texture is made of goes by the second set of coordinates.
bool goes_by_second_uvs(std::span<const Texture> textures, std::uint32_t index);

/// Brings the pictures that a texture is made of into memory as a whole.
void keep_in_memory(std::span<Texture> textures, std::uint32_t index);

/// The value of a picture at a point: bilinear of the four pixels around. Black where the point is not
/// finite.
Rgb bilinear(const MipLevel& image, Wrap wrap, Vec2 uv);
/// That of the pixel at a point; likewise.
Rgb nearest(const MipLevel& image, Wrap wrap, Vec2 uv);

/// The value of a texture of a scene. The same bits on every machine.
Rgb evaluate(std::span<const Texture> textures, std::uint32_t index, const TexturePoint& at);

/// Asks memory for the texels that evaluate() reads there, so that they are near when it comes: many lookups
/// wait for memory at once. Texels in tiles are not asked for.
void prefetch_texels(std::span<const Texture> textures, std::uint32_t index, const TexturePoint& at);

/// What a texture may be made of, each part counted as often as it is named: all are evaluated at each hit.
inline constexpr std::uint64_t most_texture_parts = 4096;

/// Throws Error where a texture names one that does not stand before it, has no picture, or is made of too
/// many.
void check_textures(std::span<const Texture> textures);

}  // namespace twinray
