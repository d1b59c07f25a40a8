// SPDX-License-Identifier: Apache-2.0
// load_ray in four lanes at a time: the steps of load_ray_scalar, with the same bits.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>

#include "accel/canonical/checked_ray.h"

namespace twinray {
namespace {

/// Four numbers of a ray from a place on: three of a vector, and what follows. Read as bytes of the whole
/// ray, for no member has four.
Float4 load_four(const Ray& ray, std::size_t place) {
  Float4 lanes;
  std::memcpy(&lanes, reinterpret_cast<const unsigned char*>(&ray) + place, sizeof lanes);
  return lanes;
}

/// `origin` and `direction` each have the number in their last lane that follows in the ray: the direction's
/// x, and t_min.
bool is_valid(const Ray& ray, Float4 origin, Float4 direction) {
  constexpr float finite = std::numeric_limits<float>::max();
  const Int4 in_range =
      (abs(origin) <= Float4{max_origin, max_origin, max_origin, finite}) & (abs(direction) <= finite);
  return mask_bits(in_range) == 0xf && (ray.t_min >= 0) & (ray.t_min <= ray.t_max);
}

// No branch on the direction: they are mispredicted for every other bounce ray.

/// `largest`: the direction's largest component, in every lane.
void load_slab(CheckedRay& checked, Float4 origin, Float4 direction, Float4 largest) {
  const Int4 sign = Int4(direction) & std::numeric_limits<std::int32_t>::min();
  const Float4 forward = Float4(Int4(largest_of_three(abs(origin)) * slab_margin) | sign);
  const Float4 inverse = 1.0f / Float4(Int4(max(abs(direction), largest * least_component)) | sign);
  checked.is_negative = (sign >> 31) & 1;
  checked.near_origin = origin + forward;
  checked.far_origin = origin - forward;
  checked.near_inverse = inverse * (1.0f - slab_margin);
  checked.far_inverse = inverse * (1.0f + slab_margin);
}

void load_shear(CheckedRay& checked, Float4 origin, Float4 direction) {
  float o[4], d[4];
  std::memcpy(o, &origin, sizeof o);
  std::memcpy(d, &direction, sizeof d);
  const float x = std::fabs(d[0]), y = std::fabs(d[1]), z = std::fabs(d[2]);
  const bool is_x = (x > y) & (x > z), is_y = !(x > y) & (y > z);
  constexpr int next[3] = {1, 2, 0};
  const int kz = 2 - 2 * is_x - is_y, kx = next[kz], ky = next[kx];
  checked.axes = Int4{kx, ky, kz, kz};
  checked.shear = Float4{d[kx], d[ky], 1, 1} / splat(d[kz]);
  checked.turned_origin = Float4{o[kx], o[ky], o[kz], o[kz]};
}

}  // namespace

bool load_ray(const Ray& ray, CheckedRay& checked) noexcept {
  static_assert(offsetof(Ray, direction) == 12 && offsetof(Ray, t_min) == 24 && sizeof(Ray) >= 28);
  const Float4 origin = load_four(ray, offsetof(Ray, origin));
  Float4 direction = load_four(ray, offsetof(Ray, direction));
  if (!is_valid(ray, origin, direction)) return false;
  checked.origin = ray.origin;
  checked.direction = ray.direction;
  checked.t_min = ray.t_min;
  checked.t_max = std::min(ray.t_max, max_t);
  checked.t_scale = 1;
  checked.instance = no_instance;
  Float4 largest = largest_of_three(abs(direction));
  if (!(largest[0] >= min_direction && largest[0] <= max_direction)) {
    if (!scale_direction(checked)) return false;
    direction = Float4{checked.direction.x, checked.direction.y, checked.direction.z, 0};
    largest = largest_of_three(abs(direction));
  }
  load_slab(checked, origin, direction, largest);
  load_shear(checked, origin, direction);
  return true;
}

}  // namespace twinray
