// SPDX-License-Identifier: Apache-2.0
// Colours, or numbers, that differ over a surface: plain values, linked by index. A texture may name others
// that stand before it in Scene::textures.
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <variant>

#include "core/coordinate_set.h"
#include "core/mip_map.h"
#include "core/noise.h"
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

/// An affine map of points: x' = m[0] . (x, y, z, 1), and so on.
struct PointTransform {
  float m[3][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}};

  Vec3 operator()(const Vec3& p) const {
    const auto row = [&](int i) { return m[i][0] * p.x + m[i][1] * p.y + m[i][2] * p.z + m[i][3]; };
    return {row(0), row(1), row(2)};
  }
  friend bool operator==(const PointTransform&, const PointTransform&) = default;
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
  bool of_vertices = false;  ///< It is one mesh's colours of vertices (io/vertex_colors.h).
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

/// As a checkerboard, of cubes of side 1: the first has (0, 0, 0) at its corner, in space.
struct CubesTexture {
  std::uint32_t first = 0, second = 0;
};

/// Dots of the first texture on the second one (core/noise.h).
struct DotsTexture {
  std::uint32_t first = 0, second = 0;
  UvTransform uv;
};

/// Bilinear between the corners of the unit square of the transformed coordinates, and beyond.
struct BilinearTexture {
  Rgb v00, v10, v01, v11;  ///< At (0, 0), (1, 0), (0, 1), (1, 1).
  UvTransform uv;
};

/// |cos| first + (1 - |cos|) second, by the angle between a direction and the geometric normal.
struct DirectionMixTexture {
  std::uint32_t first = 0, second = 0;
  Vec3 direction{0, 1, 0};  ///< Unit; in the scene.
};

/// Sums of noise in space (core/noise.h): clouds, wrinkles, waves in gusts of wind, all of them a number that
/// may be negative; and coloured layers of marble, across y.
enum class NoisePattern { fbm, wrinkled, windy, marble };
struct NoiseTexture {
  NoisePattern pattern = NoisePattern::fbm;
  Octaves octaves;         ///< Not of windy.
  float scale = 1;         ///< Of marble: the point is multiplied by it,
  float variation = 0.2f;  ///< and the layers bend by so much.
};

/// By what coordinates a texture is placed that goes by the points of the scene: themselves, for patterns in
/// space; x and y; the angle from +z in half turns and that around it, from +x to +y, in turns; that angle
/// from -x on, and z.
enum class TexturePlacement { space, planar, spherical, cylindrical };

/// A pattern that does not lie by the surface's own coordinates, but by those of the point. A pattern: a
/// picture, noise, the corners of a square, or a board, dots or cubes of constants.
struct PlacedTexture {
  std::uint32_t texture = 0;
  TexturePlacement placement = TexturePlacement::space;
  PointTransform to_texture;  ///< From the scene.
};

using TextureModel =
    std::variant<ConstantTexture, ImageTexture, ScaleTexture, MixTexture, CheckerboardTexture, CubesTexture,
                 DotsTexture, BilinearTexture, DirectionMixTexture, NoiseTexture, PlacedTexture>;

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
  // For textures that go by it (goes_by_position):
  Vec3 position;    ///< the point in the scene,
  Vec3 normal;      ///< its unit geometric normal, on either side,
  float width = 0;  ///< and how wide, in the scene, what one sample sees of the surface is.
};

}  // namespace twinray
