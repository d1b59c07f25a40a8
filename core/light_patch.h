// SPDX-License-Identifier: Apache-2.0
// Points of a mesh light, chosen more often where they send more light.
//
// A lamp's rectangle, seen from a wall, sends several times as much from one end as from the other: the
// cosines at both surfaces and the distance differ. So what arrives is worked out for its four corners,
// interpolated bilinearly over the rectangle, and the points are chosen with that density (as pbrt warps
// its light samples by corners' cosines: Hart et al., "Practical Product Sampling by Fitting and Composing
// Warps", 2020; here the corners have the distance, too, so that no solid angle is needed). A light of a few
// rectangles and triangles is chosen from in the same way, each by its size and the mean of its corners.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "core/geometry.h"
#include "core/light.h"
#include "core/vec.h"

namespace twinray {

/// A flat piece of a mesh, the image of the unit square: two triangles that form a parallelogram, or one
/// triangle (by square_to_triangle, which folds the corner (1, 1) onto the middle of an edge).
struct LightPatch {
  /// Where the square's corners (0, 0), (1, 0), (1, 1) and (0, 1) lie.
  std::array<Vec3, 4> corners;
  Vec3 normal;      ///< Unit, out of the front.
  float share = 1;  ///< Of the light's area, > 0.
  bool is_parallelogram = false;
  /// Of the mesh: that of the points with x >= y, and that of those with x < y. Equal for one triangle.
  std::array<std::uint32_t, 2> triangles{};
  /// Of a parallelogram: which corner of it each vertex of these triangles is.
  std::array<std::array<std::uint8_t, 3>, 2> corner_of{};
};

/// A mesh light of few patches.
struct PatchLight {
  /// More are chosen from by area.
  static constexpr std::size_t most = 8;
  /// What each point gets, as a part of the mean over the light, beyond its density by the corners: they do
  /// not know what lies between them, so no point may be chosen much too seldom.
  static constexpr float floor = 0x1p-4f;

  std::vector<LightPatch> patches;  ///< Empty: the light has more, or no area.
  EmissionSide side = EmissionSide::both;
};

/// The patches of a light whose triangles have the total area `area`.
PatchLight patch_light(const Mesh& mesh, EmissionSide side, double area);

/// Where light is gathered: at a surface, or at a point in a medium, where all directions are alike.
struct Receiver {
  Vec3 position;
  Vec3 normal;                      ///< The unit shading normal on the viewer's side; 0 in a medium.
  bool lets_light_through = false;  ///< Light from behind counts, too.

  bool is_in_medium() const { return normal == Vec3{}; }
  /// By how much a surface is foreshortened, seen along a vector to where light comes from: the cosine with
  /// its normal, times the vector's length.
  float facing(const Vec3& towards) const { return is_in_medium() ? length(towards) : dot(normal, towards); }
};

/// What a receiver gets from the corners of each patch of a light, relative to the mean over the light.
class PatchWeights {
 public:
  /// The light has patches, and outlives this.
  PatchWeights(const PatchLight& light, const Receiver& receiver);

  /// A point of a triangle.
  struct Choice {
    std::uint32_t triangle = 0;  ///< Of the mesh.
    float u = 0, v = 0;          ///< The weights of its second and third vertex.
    float density = 1;           ///< Per area, times the light's area; > 0.
  };
  /// u in [0, 1)^2.
  Choice choose(Vec2 u) const;
  /// The density with which `choose` gives a point: per area, times the light's area.
  float density(std::uint32_t triangle, float u, float v) const;

 private:
  /// That a patch is chosen.
  float probability(std::size_t patch) const;

  const PatchLight& light_;
  std::array<std::array<float, 4>, PatchLight::most> corners_{};
};

}  // namespace twinray
