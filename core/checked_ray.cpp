// SPDX-License-Identifier: Apache-2.0
#include "core/checked_ray.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace twinray {
namespace {

constexpr float max_origin = 0x1p60f;

/// A direction component for the slab test: never closer to zero than 2^-60 of the largest one, so that the
/// reciprocal stays finite; what that moves a ray by is far below slab_margin.
float slab_component(float d, float largest) {
  return std::copysign(std::max(std::fabs(d), largest * 0x1p-60f), d);
}

bool is_valid(const Ray& ray) {
  return max_abs(ray.origin) <= max_origin && is_finite(ray.origin) && is_finite(ray.direction) &&
         max_abs(ray.direction) > 0 && ray.t_min >= 0 && ray.t_min <= ray.t_max && std::isfinite(ray.t_min);
}

void load_direction(const Ray& ray, CheckedRay& checked) {
  constexpr float infinite = std::numeric_limits<float>::max();
  const float largest = max_abs(ray.direction);
  checked.direction = ray.direction;
  checked.t_min = ray.t_min;
  checked.t_max = std::min(ray.t_max, infinite);
  checked.t_scale = 1;
  if (largest >= 0x1p-40f && largest <= 0x1p40f) return;
  const int k = std::ilogb(largest);
  for (int axis = 0; axis < 3; ++axis) checked.direction[axis] = std::ldexp(ray.direction[axis], -k);
  checked.t_min = std::ldexp(checked.t_min, k);
  checked.t_max = std::min(std::ldexp(checked.t_max, k), infinite);
  checked.t_scale = std::ldexp(1.0, -k);
}

// No branch on the direction: they are mispredicted for every other bounce ray.

void load_slab(CheckedRay& checked) {
  const float largest = max_abs(checked.direction);
  const float shift = max_abs(checked.origin) * slab_margin;
  for (int axis = 0; axis < 3; ++axis) {
    const float forward = std::copysign(shift, checked.direction[axis]);
    const float inverse = 1.0f / slab_component(checked.direction[axis], largest);
    checked.is_negative[axis] = std::signbit(checked.direction[axis]);
    checked.near_origin[axis] = checked.origin[axis] + forward;
    checked.far_origin[axis] = checked.origin[axis] - forward;
    checked.near_inverse[axis] = inverse * (1.0f - slab_margin);
    checked.far_inverse[axis] = inverse * (1.0f + slab_margin);
  }
}

void load_shear(CheckedRay& checked) {
  const float d[3] = {checked.direction.x, checked.direction.y, checked.direction.z};
  const float x = std::fabs(d[0]), y = std::fabs(d[1]), z = std::fabs(d[2]);
  const bool is_x = (x > y) & (x > z), is_y = !(x > y) & (y > z);
  constexpr int next[3] = {1, 2, 0};
  checked.kz = 2 - 2 * is_x - is_y;
  checked.kx = next[checked.kz];
  checked.ky = next[checked.kx];
  checked.sx = d[checked.kx] / d[checked.kz];
  checked.sy = d[checked.ky] / d[checked.kz];
  checked.sz = 1.0f / d[checked.kz];
}

}  // namespace

bool load_ray(const Ray& ray, CheckedRay& checked) noexcept {
  if (!is_valid(ray)) return false;
  checked.origin = ray.origin;
  load_direction(ray, checked);
  load_slab(checked);
  load_shear(checked);
  return true;
}

}  // namespace twinray
