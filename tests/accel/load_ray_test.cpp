// SPDX-License-Identifier: Apache-2.0
#include <bit>
#include <cstring>
#include <limits>

#include "accel/wide/kernel.h"
#include "tests/support/catch.h"
#include "tests/support/hostile.h"

using namespace twinray;
using namespace twinray::test;

namespace {

/// Any bits, or one of those with a meaning of their own.
float unusual_number(Random& random) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  constexpr float special[] = {
      0,         -0.0f,   infinity, -infinity, std::numeric_limits<float>::quiet_NaN(),
      0x1p-149f, 0x1p40f, 0x1p-40f, 0x1p60f,   std::numeric_limits<float>::max()};
  if (random.below(2) == 0) return special[random.below(int(std::size(special)))];
  return std::bit_cast<float>(std::uint32_t(random.between(0, 0xffff)) << 16 |
                              std::uint32_t(random.between(0, 0xffff)));
}

/// A ray of a hostile pair, or any other; most of them with something unusual in one place.
Ray unusual_ray(Random& random) {
  Ray ray = hostile_pair(random).ray;
  if (random.below(2) == 0) ray = {.origin = random.in_cube(2), .direction = random.in_cube()};
  switch (random.below(6)) {
    case 0:
      ray.direction[random.below(3)] = unusual_number(random);
      break;
    case 1:
      ray.origin[random.below(3)] = unusual_number(random);
      break;
    case 2:
      ray.t_min = unusual_number(random);
      break;
    case 3:
      ray.t_max = unusual_number(random);
      break;
    case 4:  // Two components of the same size: which axis is dominant?
      ray.direction[random.below(3)] = -ray.direction[random.below(3)];
      break;
    default:
      break;
  }
  return ray;
}

/// In all lanes that have a meaning.
bool has_same_bits(const CheckedRay& a, const CheckedRay& b) {
  const auto same = [](const auto& x, const auto& y, std::size_t size) {
    return std::memcmp(&x, &y, size) == 0;
  };
  constexpr std::size_t three = 3 * sizeof(float);
  return same(a.origin, b.origin, three) && same(a.direction, b.direction, three) &&
         same(a.t_min, b.t_min, sizeof(float)) && same(a.t_max, b.t_max, sizeof(float)) &&
         a.t_scale == b.t_scale && same(a.near_origin, b.near_origin, three) &&
         same(a.far_origin, b.far_origin, three) && same(a.near_inverse, b.near_inverse, three) &&
         same(a.far_inverse, b.far_inverse, three) && same(a.is_negative, b.is_negative, three) &&
         same(a.axes, b.axes, three) && same(a.shear, b.shear, three) &&
         same(a.turned_origin, b.turned_origin, three);
}

}  // namespace

TEST_CASE("all ways to load a ray give the bits of the scalar one, and refuse the same rays") {
  const std::vector<WideKernel> kernels = wide_kernels();
  Random random(8);
  int valid = 0, invalid = 0;
  for (int i = 0; i < 200000; ++i) {
    const Ray ray = unusual_ray(random);
    CheckedRay expected;
    const bool is_valid = load_ray_scalar(ray, expected);
    (is_valid ? valid : invalid) += 1;
    CheckedRay in_lanes;
    if (load_ray(ray, in_lanes) != is_valid) FAIL("load_ray differs on whether ray " << i << " is valid");
    if (is_valid && !has_same_bits(in_lanes, expected)) FAIL("load_ray differs on ray " << i);
    for (const WideKernel& kernel : kernels) {
      CheckedRay loaded;
      if (kernel.load(ray, loaded) != is_valid)
        FAIL(kernel.name << " differs on whether ray " << i << " is valid");
      if (is_valid && !has_same_bits(loaded, expected)) FAIL(kernel.name << " differs on ray " << i);
    }
  }
  CHECK(valid > 100000);
  CHECK(invalid > 10000);
}
