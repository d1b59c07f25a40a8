// SPDX-License-Identifier: Apache-2.0
// How a packet comes into a scene with instances and into one of them, compared with each of its rays alone,
// in the instruction set that every file is compiled for.
#include "accel/canonical/instance_packet-inl.h"

#include <bit>
#include <cmath>
#include <limits>

#include "tests/support/catch.h"
#include "tests/support/instances.h"
#include "tests/support/packets.h"
#include "tests/support/shapes.h"

using namespace twinray;
using namespace twinray::test;

namespace {

using HWY_NAMESPACE::RayLanes;
using HWY_NAMESPACE::RayPacket;
using HWY_NAMESPACE::WorldPacket;
using Numbers = RayPacket::Numbers;

bool has_bits(float a, float b) { return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b); }

/// Whether a ray of a packet is this one, bit for bit.
bool is_ray(const RayPacket& packet, std::size_t i, const CheckedRay& ray) {
  Ray room;
  const Ray& given = packet.given->ray(i, room);
  bool is = has_bits(packet.t_min.values[i], ray.t_min) && has_bits(packet.t_max.values[i], ray.t_max);
  for (int axis = 0; axis < 3; ++axis)
    is = is && has_bits(given.origin[axis], ray.origin[axis]) &&
         has_bits(given.direction[axis], ray.direction[axis]);
  return is;
}

std::shared_ptr<const Geometry> instances_of(Kind kind) {
  return share_instanced({}, {{soup(20, 0.5f, 1)}}, {kind}, 20, 2);
}

Bundle scaled_by(Bundle rays, float size) {
  for (Ray& ray : rays) {
    ray.direction = ray.direction * size;
    ray.t_min /= size, ray.t_max /= size;
  }
  return rays;
}

/// How often there was what, all of which is compared with each ray alone.
struct Entries {
  int worlds = 0, entered = 0, missed = 0, parted = 0, beside = 0;

  void ask(const Geometry& geometry, const Bundle& rays) {
    WorldPacket world;
    if (!world.load(geometry.placed(), rays.data())) return;
    ++worlds;
    Numbers t_max;
    std::vector<CheckedRay> alone(packet_size);
    for (std::size_t i = 0; i < packet_size; ++i) {
      REQUIRE(load_ray_into(geometry, rays[i], alone[i]));
      REQUIRE(is_ray(world.packet(), i, alone[i]));
      Hit hit{.t = 3, .mesh = 0};
      const Hit back = world.scaled_back(hit, i);
      alone[i].scale_back(hit);
      REQUIRE(has_bits(back.t, hit.t));
      t_max.values[i] = i % 3 == 0 ? 6.0f : alone[i].t_max;
    }
    for (std::uint32_t number = 0; number < geometry.instances().size(); ++number)
      enter(geometry.placed(), world, alone, number, t_max);
  }

 private:
  void enter(const PlacedInstances& placed, const WorldPacket& world, const std::vector<CheckedRay>& alone,
             std::uint32_t number, const Numbers& t_max) {
    std::vector<CheckedRay> there(packet_size);
    std::vector<std::size_t> in, others;
    for (std::size_t i = 0; i < packet_size; ++i)
      (enter_instance(placed, number, alone[i], t_max.values[i], there[i]) ? in : others).push_back(i);
    RayLanes rays;
    RayPacket own;
    switch (world.enter(placed, number, t_max, rays, own)) {
      case WorldPacket::Entry::missed:
        ++missed;
        CHECK(in.empty());
        return;
      case WorldPacket::Entry::parted:
        ++parted;
        return;
      case WorldPacket::Entry::entered:
        ++entered;
    }
    REQUIRE(own.instance == number);
    REQUIRE_FALSE(in.empty());
    for (const std::size_t i : in) REQUIRE(is_ray(own, i, there[i]));
    beside += int(others.size());
    for (const std::size_t i : others) {  // They hit nothing, and change no bounds of those that come there.
      REQUIRE(own.t_min.values[i] == Aabb::infinity);
      REQUIRE(own.t_max.values[i] < 0);
      Ray room, other;
      const Ray &stand_in = rays.ray(i, room), &one = rays.ray(in[0], other);
      REQUIRE(stand_in.origin == one.origin);
      REQUIRE(stand_in.direction == one.direction);
    }
  }
};

}  // namespace

TEST_CASE("a packet has in a scene with instances and in each of them the rays that it has alone") {
  Entries seen;
  for (const Kind kind : {Kind::rigid, Kind::mirrored, Kind::sheared, Kind::squashed}) {
    CAPTURE(int(kind));
    const auto geometry = instances_of(kind);
    Random random(3);
    for (int round = 0; round < 300; ++round) {
      Bundle rays = bundle(random, round % 2 == 0 ? 0 : 0.02f, 0.1f, 1.5f);
      if (round % 3 == 0) shorten(random, rays);
      seen.ask(*geometry, scaled_by(rays, std::ldexp(1.0f, random.between(-59, 58))));
    }
  }
  CHECK(seen.worlds > 600);
  CHECK(seen.entered > 400);
  CHECK(seen.missed > 1000);
  CHECK(seen.parted > 10);
  CHECK(seen.beside > 400);
}

TEST_CASE("a packet that an instance takes out of range is none in it") {
  Instancing instancing{{{0, 1}}, {{0, Transform::scaling(1e-10, 1e-10, 1e-10)}}};
  instancing.instances.push_back({0, Transform::translation(1e10, 0, 0)});
  const Geometry geometry({icosphere_mesh(1)}, nullptr, instancing);
  const Bundle rays(packet_size, {.origin = {1e10f, 1, 0.5f}, .direction = {-1, -1e-10f, -5e-11f}});
  WorldPacket world;
  REQUIRE(world.load(geometry.placed(), rays.data()));
  Numbers t_max;
  for (float& end : t_max.values) end = 2e10f;
  RayLanes own;
  RayPacket packet;
  CheckedRay alone, there;
  REQUIRE(load_ray_into(geometry, rays[0], alone));
  CHECK_FALSE(enter_instance(geometry.placed(), 0, alone, 2e10f, there));
  CHECK(world.enter(geometry.placed(), 0, t_max, own, packet) == WorldPacket::Entry::parted);
}

TEST_CASE("what is no packet in a scene with instances is left alone") {
  const auto geometry = instances_of(Kind::rigid);
  const auto loads = [&](const auto& change) {
    Random random(4);
    Bundle rays(packet_size, bundle(random, 0, 0).front());
    change(rays[5]);
    WorldPacket world;
    return world.load(geometry->placed(), rays.data());
  };
  constexpr float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  CHECK(loads([](Ray&) {}));
  CHECK(loads([](Ray& ray) { ray.t_max = inf; }));
  CHECK(loads([](Ray& ray) { ray.direction = ray.direction * 0x1p-50f; }));
  CHECK(loads([](Ray& ray) { ray.direction = ray.direction * 0x1p50f; }));
  CHECK_FALSE(loads([](Ray& ray) { ray.direction = ray.direction * 0x1p-70f; }));
  CHECK_FALSE(loads([](Ray& ray) { ray.direction = ray.direction * 0x1p70f; }));
  CHECK_FALSE(loads([](Ray& ray) { ray.direction = -ray.direction; }));
  CHECK_FALSE(loads([](Ray& ray) { ray.direction = {}; }));
  CHECK_FALSE(loads([](Ray& ray) { ray.direction.y = nan; }));
  CHECK_FALSE(loads([](Ray& ray) { ray.direction.y = inf; }));
  CHECK_FALSE(loads([](Ray& ray) { ray.origin.z = nan; }));
  CHECK_FALSE(loads([&](Ray& ray) { ray.origin.x = geometry->placed().reach() * 1.01f; }));
  CHECK_FALSE(loads([](Ray& ray) { ray.t_min = nan; }));
  CHECK_FALSE(loads([](Ray& ray) { ray.t_min = 2, ray.t_max = 1; }));
}
