// SPDX-License-Identifier: Apache-2.0
#include "accel/canonical/checked_ray.h"

#include <algorithm>
#include <cmath>

namespace twinray {
namespace {

bool is_valid(const Ray& ray) {
  for (int axis = 0; axis < 3; ++axis)
    if (!(std::fabs(ray.origin[axis]) <= max_origin) || !std::isfinite(ray.direction[axis])) return false;
  return ray.t_min >= 0 && std::isfinite(ray.t_min) && ray.t_min <= ray.t_max;
}

void load_slab(CheckedRay& checked) {
  const float reach = max_abs(checked.origin) * slab_margin;
  const float least = max_abs(checked.direction) * least_component;
  for (int axis = 0; axis < 3; ++axis) {
    const float origin = checked.origin[axis], direction = checked.direction[axis];
    const float forward = std::copysign(reach, direction);
    const float inverse = 1 / std::copysign(std::max(std::fabs(direction), least), direction);
    checked.is_negative[axis] = std::signbit(direction);
    checked.near_origin[axis] = origin + forward;
    checked.far_origin[axis] = origin - forward;
    checked.near_inverse[axis] = inverse * (1 - slab_margin);
    checked.far_inverse[axis] = inverse * (1 + slab_margin);
  }
}

/// The axis of the largest component; of equal ones the later.
int dominant_axis(const Vec3& direction) {
  const float x = std::fabs(direction.x), y = std::fabs(direction.y), z = std::fabs(direction.z);
  if (x > y && x > z) return 0;
  return y >= x && y > z ? 1 : 2;
}

void load_shear(CheckedRay& checked) {
  const Vec3 &o = checked.origin, &d = checked.direction;
  const int z = dominant_axis(d), x = (z + 1) % 3, y = (z + 2) % 3;
  checked.axes = Int4{x, y, z, z};
  checked.shear = Float4{d[x] / d[z], d[y] / d[z], 1 / d[z], 0};
  checked.turned_origin = Float4{o[x], o[y], o[z], 0};
}

}  // namespace

[[gnu::cold]] bool scale_direction(CheckedRay& checked) noexcept {
  const float largest = max_abs(checked.direction);
  if (largest == 0) return false;
  const int k = std::ilogb(largest);
  for (int axis = 0; axis < 3; ++axis) checked.direction[axis] = std::ldexp(checked.direction[axis], -k);
  checked.t_min = std::ldexp(checked.t_min, k);
  checked.t_max = std::min(std::ldexp(checked.t_max, k), max_t);
  checked.t_scale = std::ldexp(1.0, -k);
  return true;
}

bool load_ray_scalar(const Ray& ray, CheckedRay& checked) noexcept {
  if (!is_valid(ray)) return false;
  checked.origin = ray.origin;
  checked.direction = ray.direction;
  checked.t_min = ray.t_min;
  checked.t_max = std::min(ray.t_max, max_t);
  checked.t_scale = 1;
  checked.instance = no_instance;
  const float largest = max_abs(ray.direction);
  const bool is_in_range = largest >= min_direction && largest <= max_direction;
  if (!is_in_range && !scale_direction(checked)) return false;
  load_slab(checked);
  load_shear(checked);
  return true;
}

}  // namespace twinray
