// SPDX-License-Identifier: Apache-2.0
// Sixteen rays that run close together, and what a kernel makes of them as a packet.
#pragma once
#include <algorithm>
#include <vector>

#include "accel/wide/kernel.h"
#include "accel/wide/scalar.h"
#include "tests/support/block_kernels.h"
#include "tests/support/random.h"

namespace twinray::test {

inline constexpr int packet_size = 16;
using Bundle = std::vector<Ray>;

/// Sixteen rays from about one place towards about one other, of lengths of their own, in a scene of a size.
inline Bundle bundle(Random& random, float origins, float targets, float size = 1) {
  const Vec3 origin = random.in_cube(2 * size), target = random.in_cube(0.9f * size);
  Bundle rays;
  for (int i = 0; i < packet_size; ++i) {
    const Vec3 from = origin + random.in_cube(origins * size);
    const Vec3 direction = target + random.in_cube(targets * size) - from;
    rays.push_back({.origin = from, .direction = direction * random.uniform(0.97f, 1.03f)});
  }
  return rays;
}

/// Intervals that end before and begin behind what is hit, for some.
inline void shorten(Random& random, Bundle& rays) {
  for (Ray& ray : rays) {
    if (random.below(3) == 0) ray.t_max = random.unit();
    if (random.below(3) == 0) ray.t_min = std::min(ray.t_max, random.unit() * 0.5f);
  }
}

/// How many packets there were and how many rays of them hit something, all of which are compared with what
/// each ray finds alone.
struct Seen {
  int packets = 0, hits = 0;

  template <typename Tree>
  void ask(const BasicWideKernel<Tree>& kernel, const Tree& bvh, const Geometry& geometry,
           const Bundle& rays) {
    Hit answers[packet_size];
    const std::size_t answered = kernel.closest_in_packets(bvh, geometry, rays, answers);
    if (answered == 0) return;
    REQUIRE(answered == packet_size);
    ++packets;
    for (std::size_t i = 0; i < answered; ++i) {
      QueryCounts ignored;
      const Hit alone = scalar_closest(bvh, geometry, rays[i], ignored);
      if (!test::has_same_bits(answers[i], alone))
        FAIL("ray " << i << " of a packet has another hit than alone");
      hits += bool(alone);
    }
  }
};

}  // namespace twinray::test
