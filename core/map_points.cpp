// SPDX-License-Identifier: Apache-2.0
// core/direction_map.h's map_point() and core/elementary.h's atan2_turns() in lanes of double, compiled once
// for each instruction set: each line is one of theirs, with its roundings.
#include "core/map_points.h"

#include <algorithm>

#include "core/elementary.h"
#include "core/instruction_sets.h"

#define HWY_TARGET_INCLUDE "core/map_points.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128
HWY_BEFORE_NAMESPACE();
namespace twinray::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::CappedTag<double, 8>;
using Doubles = hn::Vec<Tag>;
constexpr std::size_t width = hn::MaxLanes(Tag());

HWY_ATTR HWY_INLINE Doubles splat(double a) { return hn::Set(Tag(), a); }
HWY_ATTR HWY_INLINE Doubles squared(Doubles a) { return hn::Mul(a, a); }

/// Of x in [0, 1].
HWY_ATTR HWY_INLINE Doubles atan_turns(Doubles x) {
  constexpr double atan_of_quarters[] = {0, 0.24497866312686415, 0.46364760900080612, 0.64350110879328439,
                                         0.78539816339744831};
  const Doubles nearest = hn::Trunc(hn::Add(hn::Mul(splat(4), x), splat(0.5)));
  Doubles start = splat(atan_of_quarters[4]);
  for (int quarter = 3; quarter >= 0; --quarter)
    start = hn::IfThenElse(hn::Le(nearest, splat(quarter)), splat(atan_of_quarters[quarter]), start);
  const Doubles center = hn::Mul(splat(0.25), nearest);
  const Doubles t = hn::Div(hn::Sub(x, center), hn::Add(splat(1), hn::Mul(x, center)));
  const Doubles z = squared(t);
  Doubles series = splat(1.0 / 17);
  for (int odd = 15; odd >= 1; odd -= 2) series = hn::Sub(splat(1.0 / odd), hn::Mul(z, series));
  return hn::Mul(hn::Add(start, hn::Mul(t, series)), splat(turns_per_radian));
}

HWY_ATTR HWY_INLINE Doubles atan2_turns(Doubles y, Doubles x) {
  const Doubles zero = splat(0), ax = hn::Abs(x), ay = hn::Abs(y);
  const auto is_flat = hn::Le(ay, ax);
  const Doubles slope = hn::Div(hn::IfThenElse(is_flat, ay, ax), hn::IfThenElse(is_flat, ax, ay));
  const Doubles near = atan_turns(slope);
  const Doubles eighth = hn::IfThenElse(is_flat, near, hn::Sub(splat(0.25), near));
  const Doubles half = hn::IfThenElse(hn::Lt(x, zero), hn::Sub(splat(0.5), eighth), eighth);
  const Doubles turns = hn::IfThenElse(hn::Lt(y, zero), hn::Sub(splat(1), half), half);
  return hn::IfThenZeroElse(hn::Eq(hn::Max(ax, ay), zero), turns);
}

struct Points {
  Doubles x, y;
};

HWY_ATTR HWY_INLINE Points latitude_longitude_points(Doubles x, Doubles y, Doubles z) {
  const Doubles horizontal = hn::Sqrt(hn::Add(squared(x), squared(z)));
  const Doubles around = hn::Add(atan2_turns(hn::Neg(z), x), splat(0.5));
  return {hn::IfThenElse(hn::Lt(around, splat(1)), around, hn::Sub(around, splat(1))),
          hn::Mul(splat(2), atan2_turns(horizontal, y))};
}

HWY_ATTR HWY_INLINE Points equal_area_points(Doubles x, Doubles y, Doubles z) {
  const Doubles one = splat(1), half = splat(0.5);
  const Doubles horizontal = hn::Add(squared(x), squared(y));
  const Doubles length = hn::Sqrt(hn::Add(horizontal, squared(z)));
  const Doubles r = hn::Sqrt(hn::Div(horizontal, hn::Mul(length, hn::Add(length, hn::Abs(z)))));
  const Doubles quarter = hn::Mul(splat(4), atan2_turns(hn::Abs(y), hn::Abs(x)));
  const Doubles v = hn::Mul(quarter, r), u = hn::Sub(r, v);
  const auto is_below = hn::Lt(hn::CopySign(one, z), splat(0));  // A -0 is, too.
  const Doubles across = hn::IfThenElse(is_below, hn::Sub(one, v), u);
  const Doubles down = hn::IfThenElse(is_below, hn::Sub(one, u), v);
  return {hn::Add(half, hn::Mul(half, hn::CopySign(across, x))),
          hn::Add(half, hn::Mul(half, hn::CopySign(down, y)))};
}

HWY_ATTR void map_points(MapLayout layout, std::span<const Vec3> directions, std::span<MapPoint> points) {
  for (std::size_t first = 0; first < directions.size(); first += width) {
    const std::size_t count = std::min(width, directions.size() - first);
    HWY_ALIGN double x[width], y[width], z[width];
    for (std::size_t i = 0; i < width; ++i) {  // The last direction again where there are no more.
      const Vec3& direction = directions[first + std::min(i, count - 1)];
      x[i] = direction.x, y[i] = direction.y, z[i] = direction.z;
    }
    const Doubles dx = hn::Load(Tag(), x), dy = hn::Load(Tag(), y), dz = hn::Load(Tag(), z);
    const auto [across, down] = layout == MapLayout::equal_area ? equal_area_points(dx, dy, dz)
                                                                : latitude_longitude_points(dx, dy, dz);
    hn::Store(across, Tag(), x);
    hn::Store(down, Tag(), y);
    for (std::size_t i = 0; i < count; ++i) points[first + i] = {x[i], y[i]};
  }
}

MapPointsKernel map_points_kernel() { return {simd_name(hwy::TargetName(HWY_TARGET)), map_points}; }

}  // namespace
}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#if HWY_ONCE
#include "core/supported_sets.h"

namespace twinray {

std::vector<MapPointsKernel> map_points_kernels() {
  std::vector<MapPointsKernel> kernels;
  TWINRAY_APPEND_SUPPORTED(kernels, map_points_kernel());
  return kernels;
}

void map_points(MapLayout layout, std::span<const Vec3> directions, std::span<MapPoint> points) {
  static const std::vector<MapPointsKernel> kernels = map_points_kernels();
  if (!kernels.empty()) return kernels.front().map_points(layout, directions, points);
  for (std::size_t i = 0; i < directions.size(); ++i) points[i] = map_point(layout, directions[i]);
}

}  // namespace twinray
#endif
