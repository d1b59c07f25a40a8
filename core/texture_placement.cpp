// SPDX-License-Identifier: Apache-2.0
#include "core/texture_placement.h"

#include <algorithm>
#include <cmath>

#include "core/angle.h"
#include "core/elementary.h"

namespace twinray {
namespace {

Vec3 row(const PointTransform& map, int i) { return {map.m[i][0], map.m[i][1], map.m[i][2]}; }
Vec3 column(const PointTransform& map, int i) { return {map.m[0][i], map.m[1][i], map.m[2][i]}; }

/// From +x to +y around the z-axis, in turns.
float turns_around(const Vec3& p) { return float(atan2_turns(p.y, p.x)); }
float distance_from_axis(const Vec3& p) { return std::sqrt(p.x * p.x + p.y * p.y); }

/// Coordinates, and how many units of them lie on a unit of length around there.
struct Place {
  Vec2 uv;
  float density = 0;
};

/// Both angles change fastest on the axis: no footprint is larger than all of the picture.
float bounded(float density) { return std::isfinite(density) ? density : 0; }

Place on_sphere(const Vec3& p) {
  const float around = distance_from_axis(p);
  const float per_turn = 2 * pi * around, per_half_turn = pi * length(p);
  return {{2 * float(atan2_turns(around, p.z)), turns_around(p)},
          bounded(1 / std::sqrt(per_turn * per_half_turn))};
}

Place on_cylinder(const Vec3& p) {
  const float turns = turns_around(p);
  return {{turns <= 0.5f ? turns + 0.5f : turns - 0.5f, p.z},
          bounded(1 / std::sqrt(2 * pi * distance_from_axis(p)))};
}

}  // namespace

float mean_stretch(const PointTransform& map) {
  return (length(column(map, 0)) + length(column(map, 1)) + length(column(map, 2))) / 3;
}

[[gnu::noinline]] TexturePoint placed_point(const PlacedTexture& texture, const TexturePoint& at) {
  const PointTransform& map = texture.to_texture;
  TexturePoint own = at;
  own.position = map(at.position);
  own.width = at.width * mean_stretch(map);
  if (!is_finite(own.position)) own.position = {};
  const Vec3& p = own.position;
  switch (texture.placement) {
    case TexturePlacement::space:
      return own;
    case TexturePlacement::planar:
      own.uv = {p.x, p.y};
      own.footprint = at.width * std::sqrt(length(row(map, 0)) * length(row(map, 1)));
      break;
    case TexturePlacement::spherical:
    case TexturePlacement::cylindrical: {
      const Place place = texture.placement == TexturePlacement::spherical ? on_sphere(p) : on_cylinder(p);
      own.uv = place.uv;
      own.footprint = own.width * place.density;
      break;
    }
  }
  own.second_uv = own.uv, own.second_footprint = own.footprint;
  return own;
}

}  // namespace twinray
