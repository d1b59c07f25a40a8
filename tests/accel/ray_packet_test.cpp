// SPDX-License-Identifier: Apache-2.0
// What a packet knows of its rays, compared with what load_ray_scalar() makes of each, in the instruction set
// that every file is compiled for.
#include "accel/canonical/ray_packet-inl.h"

#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/support/catch.h"
#include "tests/support/random.h"

using namespace twinray;

namespace {

using Packet = HWY_NAMESPACE::RayPacket;
constexpr std::size_t packet_rays = Packet::packet_size;

std::uint32_t bits_of_number(float x) { return std::bit_cast<std::uint32_t>(x); }

/// From about one place in about one direction.
std::vector<Ray> rays_close_together(Random& random) {
  const float size = std::ldexp(1.0f, random.between(-30, 30));
  const Vec3 origin = random.in_cube(size), direction = random.in_cube();
  std::vector<Ray> rays;
  for (std::size_t i = 0; i < packet_rays; ++i)
    rays.push_back({.origin = origin + random.in_cube(size * 0.01f),
                    .direction = direction + random.in_cube(0.03f),
                    .t_min = random.unit(),
                    .t_max = i % 2 == 0 ? 2 + random.unit() : std::numeric_limits<float>::infinity()});
  return rays;
}

/// The same of each ray, bit for bit.
void check_ray(const Packet& packet, std::size_t i, const CheckedRay& ray) {
  CHECK(bits_of_number(packet.t_min.values[i]) == bits_of_number(ray.t_min));
  CHECK(bits_of_number(packet.t_max.values[i]) == bits_of_number(ray.t_max));
  for (int k = 0; k < 3; ++k) {
    CHECK(packet.axes[k] == ray.axes[k]);
    CHECK(packet.slab[k].is_negative == (ray.is_negative[k] != 0));
    CHECK(bits_of_number(packet.shear[k].values[i]) == bits_of_number(ray.shear[k]));
    CHECK(bits_of_number(packet.turned_origin[k].values[i]) == bits_of_number(ray.turned_origin[k]));
  }
}

/// No ray enters a box earlier, or leaves it later, than the packet does.
void check_bounds(const Packet& packet, const CheckedRay& ray) {
  CHECK(packet.least_t_min <= ray.t_min);
  for (int axis = 0; axis < 3; ++axis) {
    const HWY_NAMESPACE::PacketAxis& slab = packet.slab[axis];
    const float side = slab.is_negative ? -1 : 1;
    CHECK(side * slab.near_origin >= side * ray.near_origin[axis]);
    CHECK(side * slab.far_origin <= side * ray.far_origin[axis]);
    CHECK(slab.near_inverse[0] <= ray.near_inverse[axis]);
    CHECK(slab.near_inverse[1] >= ray.near_inverse[axis]);
    CHECK(slab.far_inverse[0] <= ray.far_inverse[axis]);
    CHECK(slab.far_inverse[1] >= ray.far_inverse[axis]);
  }
}

}  // namespace

TEST_CASE("a packet knows of each ray what it is alone, and bounds of all") {
  Random random(17);
  int packets = 0;
  for (int round = 0; round < 400; ++round) {
    const std::vector<Ray> rays = rays_close_together(random);
    HWY_NAMESPACE::RayLanes lanes;
    Packet packet;
    if (!lanes.load(rays.data()) || !packet.load(lanes)) continue;
    ++packets;
    for (std::size_t i = 0; i < packet_rays; ++i) {
      CheckedRay ray;
      REQUIRE(load_ray_scalar(rays[i], ray));
      check_ray(packet, i, ray);
      check_bounds(packet, ray);
    }
  }
  CHECK(packets > 200);
}

TEST_CASE("the bounds of equal rays are those of one") {
  Random random(18);
  for (int round = 0; round < 100; ++round) {
    const std::vector<Ray> rays(packet_rays, rays_close_together(random).front());
    HWY_NAMESPACE::RayLanes lanes;
    Packet packet;
    REQUIRE(lanes.load(rays.data()));
    REQUIRE(packet.load(lanes));
    CheckedRay ray;
    REQUIRE(load_ray_scalar(rays.front(), ray));
    for (int axis = 0; axis < 3; ++axis) {
      const HWY_NAMESPACE::PacketAxis& slab = packet.slab[axis];
      CHECK(slab.near_origin == ray.near_origin[axis]);
      CHECK(slab.far_origin == ray.far_origin[axis]);
      for (int end = 0; end < 2; ++end) {
        CHECK(slab.near_inverse[end] == ray.near_inverse[axis]);
        CHECK(slab.far_inverse[end] == ray.far_inverse[axis]);
      }
    }
  }
}
