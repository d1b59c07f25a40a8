// SPDX-License-Identifier: Apache-2.0
// Packets of rays that run close together: each ray gets the answer that it gets alone, and what is no packet
// is left to others.
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "tests/support/catch.h"
#include "tests/support/cut_outs.h"
#include "tests/support/instances.h"
#include "tests/support/packets.h"
#include "tests/support/shapes.h"
#include "tests/support/wide_engine.h"

using namespace twinray;
using namespace twinray::test;

namespace {

std::vector<std::shared_ptr<const Geometry>> geometries() {
  Mesh twice = soup(100, 0.4f, 3);  // Ties, which the name decides.
  Mesh first = twice;
  return {share({soup(12, 2, 10)}),
          share({soup(8, 1, 1)}),
          share({soup(2000, 0.04f, 2)}),
          share({first, twice}),
          share({random_spheres(6, 0.5f, 4), soup(6, 1, 5)}),
          share_cut_out({soup(30, 0.8f, 6), random_spheres(3, 0.5f, 7)}, {random_alpha(8), random_alpha(9)})};
}

/// Instances of every kind, with shapes beside them and without; some with holes.
std::vector<std::shared_ptr<const Geometry>> instanced_geometries() {
  const std::vector<std::vector<Shape>> prototypes{{soup(60, 0.3f, 1), random_spheres(3, 0.3f, 2)},
                                                   {icosphere_mesh(1)}};
  std::vector<std::shared_ptr<const Geometry>> geometries;
  for (const Kind kind : {Kind::rigid, Kind::mirrored, Kind::sheared, Kind::squashed})
    geometries.push_back(share_instanced({soup(20, 0.5f, 3)}, prototypes, {kind}, 5, 4));
  geometries.push_back(share_instanced({}, {{icosphere_mesh(2)}}, {Kind::rigid, Kind::scaled}, 8, 5));
  Instancing twice{{{0, 1}}, {{0, {}}, {0, Transform::translation(3, 0, 0)}}};  // Ties, as above.
  twice.instances.insert(twice.instances.end(), twice.instances.begin(), twice.instances.begin() + 2);
  geometries.push_back(
      std::make_shared<const Geometry>(std::vector<Shape>{icosphere_mesh(2)}, nullptr, twice));
  const auto whole = share_instanced({}, {{soup(60, 0.4f, 6)}, {random_spheres(9, 0.4f, 7)}},
                                     {Kind::rigid, Kind::mirrored}, 6, 8);
  const std::vector<Texture> alphas{random_alpha(1), constant_alpha(0.5f)};
  std::vector<ShapeBinding> bindings(2);
  bindings[0].alpha = 0, bindings[1].alpha = 1;
  geometries.push_back(std::make_shared<const Geometry>(
      cut_out(whole->shapes(), bindings, alphas, {whole->prototypes(), whole->instances()})));
  return geometries;
}

/// Asks every kernel for bundles of rays in scenes of a size.
template <typename Kernels, typename Build>
void compare_all(const std::vector<std::shared_ptr<const Geometry>>& geometries, float size,
                 const Kernels& kernels, const Build& build) {
  for (const auto& geometry : geometries) {
    const auto bvh = build(*geometry);
    for (const auto& kernel : kernels) {
      if (kernel.name == "scalar") continue;
      CAPTURE(kernel.name, geometry->primitive_count());
      Random random(11);
      Seen seen;
      for (int i = 0; i < 600; ++i) {
        Bundle rays = bundle(random, i % 3 == 0 ? 0 : 0.02f, i % 2 == 0 ? 0.02f : 0.1f, size);
        if (i % 4 == 0) shorten(random, rays);
        seen.ask(kernel, bvh, *geometry, rays);
      }
      CHECK(seen.packets > 100);
      CHECK(seen.hits > 100);
    }
  }
}

/// A grid of eight by eight squares in the plane z = 0, around the origin.
Mesh square_grid() {
  Mesh grid;
  for (int x = 0; x < 9; ++x)
    for (int y = 0; y < 9; ++y) grid.positions.push_back({float(x - 4), float(y - 4), 0});
  for (std::uint32_t x = 0; x < 8; ++x)
    for (std::uint32_t y = 0; y < 8; ++y) {
      const std::uint32_t a = x * 9 + y;
      grid.triangles.push_back({a, a + 9, a + 10});
      grid.triangles.push_back({a, a + 10, a + 1});
    }
  return grid;
}

/// Rays through and just beside a corner of the grid, `farthest` squares from its middle at most, along an
/// axis or askew, from one place or from many.
Bundle towards_corner(Random& random, int number, float distance, int farthest) {
  const Vec3 corner{float(random.between(-farthest, farthest)), float(random.between(-farthest, farthest)),
                    0};
  const Vec3 away = number % 2 == 0 ? Vec3{0, 0, 1} : Vec3{random.unit(), random.unit(), 1};
  const Vec3 origin = corner + away * distance;
  const float beside = std::max(0x1p-20f, distance * 0x1p-24f);  // What rounding may move a ray by.
  Bundle rays;
  for (int k = 0; k < packet_size; ++k) {
    const Vec3 side = k % 4 == 0 ? Vec3{} : random.in_cube(beside * float(1 + random.below(3)));
    rays.push_back({.origin = number % 3 == 0 ? origin + side : origin, .direction = corner + side - origin});
  }
  return rays;
}

/// Asks for so many bundles towards corners of a grid, from distances between two powers of two.
Seen ask_towards_corners(const WideKernel& kernel, int bundles, std::pair<int, int> powers, int farthest) {
  const auto geometry = share({square_grid()});
  const WideBvh bvh = build_wide(*geometry);
  Random random(5);
  Seen seen;
  for (int i = 0; i < bundles; ++i) {
    const float distance = std::ldexp(1.0f, random.between(powers.first, powers.second));
    seen.ask(kernel, bvh, *geometry, towards_corner(random, i, distance, farthest));
  }
  return seen;
}

/// For each but the scalar one, which has no packets.
template <typename Check>
void for_each_kernel(const Check& check) {
  for (const WideKernel& kernel : wide_kernels()) {
    if (kernel.name == "scalar") continue;
    CAPTURE(kernel.name);
    check(kernel);
  }
}

/// Two triangles one behind the other, far beyond the rays below.
std::shared_ptr<const Geometry> two_walls() {
  Mesh mesh;
  add_triangle(mesh, {-50, -50, 5}, {50, -50, 5}, {0, 90, 5});
  add_triangle(mesh, {-50, -50, 7}, {50, -50, 7}, {0, 90, 7});
  return share({mesh});
}

Bundle towards_walls() {
  Random random(3);
  Bundle rays;
  for (int i = 0; i < packet_size; ++i)
    rays.push_back({.direction = Vec3{1, 2, 40} + Vec3{random.unit(), random.unit(), 0}});
  return rays;
}

/// How many rays of the bundle are answered in packets; the same by every kernel.
std::size_t answered(const Geometry& geometry, const Bundle& rays) {
  const WideBvh bvh = build_wide(geometry);
  std::optional<std::size_t> count;
  for_each_kernel([&](const WideKernel& kernel) {
    std::vector<Hit> hits(rays.size());
    const std::size_t by_kernel = kernel.closest_in_packets(bvh, geometry, rays, hits.data());
    CHECK(by_kernel == count.value_or(by_kernel));
    count = by_kernel;
  });
  return count.value_or(0);
}

}  // namespace

TEST_CASE("each ray of a packet has the hit that it has alone") {
  compare_all(geometries(), 1, wide_kernels(), [](const Geometry& geometry) { return build_wide(geometry); });
}

TEST_CASE("each ray of a packet has the hit that it has alone in a compact tree") {
  compare_all(geometries(), 1, compact_kernels(),
              [](const Geometry& geometry) { return build_compact(geometry); });
}

TEST_CASE("each ray of a packet has the hit that it has alone in a scene with instances") {
  compare_all(instanced_geometries(), 1.5f, wide_kernels(WideTrees::instanced),
              [](const Geometry& geometry) { return build_wide(geometry); });
}

TEST_CASE("each ray of a packet has the hit that it has alone in a compact tree with instances") {
  compare_all(instanced_geometries(), 1.5f, compact_kernels(WideTrees::instanced),
              [](const Geometry& geometry) { return build_compact(geometry); });
}

TEST_CASE("packets along edges, through corners and beside boxes miss nothing") {
  for_each_kernel([](const WideKernel& kernel) {
    const Seen seen = ask_towards_corners(kernel, 2000, {-3, 6}, 3);
    CHECK(seen.packets > 200);
    CHECK(seen.hits == seen.packets * packet_size);
  });
}

TEST_CASE("packets from far away hit what their rays hit by rounding") {
  for_each_kernel([](const WideKernel& kernel) {
    const Seen seen = ask_towards_corners(kernel, 4000, {18, 26}, 4);
    CHECK(seen.packets > 200);
    CHECK(seen.hits > 200);
    CHECK(seen.hits < seen.packets * packet_size);
  });
}

TEST_CASE("a packet of equal rays takes the steps of one") {
  const auto geometry = share({soup(3000, 0.1f, 1), random_spheres(10, 0.2f, 2)});
  const WideBvh bvh = build_wide(*geometry);
  int packets = 0;
  for (const CountingWideKernel& kernel : counting_wide_kernels()) {
    CAPTURE(kernel.name);
    Random random(7);
    for (int i = 0; i < 300; ++i) {
      const Bundle rays(packet_size, bundle(random, 0, 0).front());
      QueryCounts together, alone;
      Hit hits[packet_size];
      if (kernel.closest_in_packets(bvh, *geometry, rays, hits, together) == 0) continue;
      ++packets;
      scalar_closest(bvh, *geometry, rays.front(), alone);
      CHECK(together.nodes == alone.nodes);
      CHECK(together.leaves == alone.leaves);
      CHECK(together.primitives == alone.primitives);
    }
  }
  CHECK(packets > 100 * int(counting_wide_kernels().size()));
}

TEST_CASE("what is no packet is left alone") {
  const auto geometry = two_walls();
  const auto with = [&](const auto& change, std::size_t ray = 5) {
    Bundle rays = towards_walls();
    change(rays[ray]);
    return answered(*geometry, rays);
  };
  constexpr float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  if (wide_kernels().size() == 1) return;  // Scalar: it has none.
  CHECK(with([](Ray&) {}) == packet_size);
  CHECK(with([](Ray& ray) { ray.t_max = 0.01f; }) == packet_size);
  CHECK(with([](Ray& ray) { ray.direction.x = -1; }) == 0);
  CHECK(with([](Ray& ray) { ray.direction.x = -0.0f; }) == 0);
  CHECK(with([](Ray& ray) { ray.direction = {50, 2, 40}; }) == 0);
  CHECK(with([](Ray& ray) { ray.direction = {2, 50, 40}; }) == 0);
  CHECK(with([](Ray& ray) { ray.direction = {nan, 2, 40}; }) == 0);
  CHECK(with([](Ray& ray) { ray.direction = {1, 2, inf}; }) == 0);
  CHECK(with([](Ray& ray) { ray.direction = {0, 0, 0}; }) == 0);
  CHECK(with([](Ray& ray) { ray.direction = ray.direction * 0x1p-60f; }) == 0);
  CHECK(with([](Ray& ray) { ray.direction = ray.direction * 0x1p60f; }) == 0);
  CHECK(with([](Ray& ray) { ray.origin.y = nan; }) == 0);
  CHECK(with([](Ray& ray) { ray.origin.y = 0x1p61f; }) == 0);
  CHECK(with([](Ray& ray) { ray.t_min = -1; }) == 0);
  CHECK(with([](Ray& ray) { ray.t_min = nan; }) == 0);
  CHECK(with([](Ray& ray) { ray.t_min = ray.t_max = inf; }) == 0);
  CHECK(with([](Ray& ray) { ray.t_max = nan; }) == 0);
  CHECK(with([](Ray& ray) { ray.t_min = 2, ray.t_max = 1; }) == 0);
  // The first and the last ray must run close together.
  CHECK(with([](Ray& ray) { ray.origin.x = 30; }, packet_size - 1) == 0);
  CHECK(with([](Ray& ray) { ray.direction = {8, 2, 40}; }, packet_size - 1) == 0);
  Bundle rays = towards_walls();
  rays.pop_back();
  CHECK(answered(*geometry, rays) == 0);
  CHECK(answered(*share({Mesh{}}), towards_walls()) == 0);
}

TEST_CASE("packets are answered up to the first that is none") {
  const auto geometry = two_walls();
  Bundle rays;
  for (int packet = 0; packet < 5; ++packet)
    for (Ray ray : towards_walls()) {
      if (packet == 3) ray.t_min = -1;
      rays.push_back(ray);
    }
  CHECK(answered(*geometry, rays) == (wide_kernels().size() == 1 ? 0 : 3 * packet_size));
}

TEST_CASE("a packet whose rays part is given up") {
  // Needles across its way: some ray comes to each of them.
  Mesh needles;
  for (int i = 0; i < 400; ++i) {
    const float x = float(i) * 0.01f - 2;
    add_triangle(needles, {x, -1, float(i % 7)}, {x + 0.005f, -1, float(i % 7)}, {x, 1, float(i % 7)});
  }
  const auto geometry = share({needles});
  Bundle wide;
  for (int i = 0; i < packet_size; ++i)
    wide.push_back({.origin = {0.001f, 0.001f, -20}, .direction = {0.01f + float(i) * 0.05f, 0.01f, 20}});
  CHECK(answered(*geometry, wide) == 0);
  const Bundle narrow(packet_size, wide.front());
  CHECK(answered(*geometry, narrow) == (wide_kernels().size() == 1 ? 0 : packet_size));
}

TEST_CASE("many rays, with packets among them, have the bits of single ones") {
  const auto geometry = share({soup(500, 0.2f, 1), random_spheres(5, 0.3f, 2)});
  const auto engine = build_accelerator(Backend::bvh, geometry);
  Random random(13);
  std::vector<Ray> rays;
  for (int i = 0; i < 300; ++i) {
    const Bundle more =
        i % 5 < 3 ? bundle(random, 0, 0.01f) : random_rays(packet_size + i % 3, geometry->bounds(), i);
    rays.insert(rays.end(), more.begin(), more.end());
  }
  std::vector<Hit> hits(rays.size());
  engine->closest_hits(rays, hits);
  for (std::size_t i = 0; i < rays.size(); ++i)
    REQUIRE(test::has_same_bits(hits[i], engine->closest_hit(rays[i])));
}
