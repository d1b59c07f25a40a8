// SPDX-License-Identifier: Apache-2.0
// What is Embree's own: its triangles as a witness, and its errors. tests/accel/agreement_test.cpp holds
// Embree with our leaf to the oracle. The file is compiled where Embree is part of the build.
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "accel/accelerator.h"
#include "accel/embree/direct.h"
#include "core/error.h"
#include "tests/support/catch.h"
#include "tests/support/shapes.h"

using namespace twinray;
using namespace twinray::test;

namespace {

/// Robust triangles of Embree and the canonical ones agree in t to about this fraction of t and of the
/// scene's size.
constexpr double t_tolerance = 1e-4;

std::unique_ptr<Accelerator> native(const std::shared_ptr<const Geometry>& geometry,
                                    const BuildOptions& options = {}) {
  return build_accelerator(Backend::embree_native, geometry, options);
}

}  // namespace

TEST_CASE("embree-native finds what the canonical engines find on generic rays") {
  const auto geometry = share({soup(300, 0.3f, 1), random_spheres(20, 0.2f, 2), soup(300, 0.2f, 3)});
  const auto canonical = build_accelerator(Backend::bvh, geometry);
  const auto witness = native(geometry);
  int hits = 0;
  for (const Ray& ray : random_rays(5000, geometry->bounds(), 4)) {
    const Hit expected = canonical->closest_hit(ray), found = witness->closest_hit(ray);
    REQUIRE(bool(found) == bool(expected));
    REQUIRE(witness->any_hit(ray) == bool(found));
    if (!found) continue;
    ++hits;
    REQUIRE(found.mesh == expected.mesh);
    REQUIRE(found.primitive == expected.primitive);
    REQUIRE(found.instance == no_instance);
    REQUIRE(found.t == Approx(expected.t).margin(t_tolerance));
    REQUIRE(found.u == Approx(expected.u).margin(0.01));
    REQUIRE(found.v == Approx(expected.v).margin(0.01));
  }
  CHECK(hits > 2000);
}

TEST_CASE("embree-native called directly hits what it hits through the interface") {
  for (const auto& geometry :
       {share({soup(300, 0.3f, 1)}), share({soup(300, 0.3f, 1), random_spheres(9, 0.2f, 2)})}) {
    const auto witness = native(geometry);
    const std::vector<Ray> rays = random_rays(2000, geometry->bounds(), 4);
    std::size_t hits = 0;
    for (const Ray& ray : rays) hits += witness->any_hit(ray);
    CHECK(hits > 500);
    CHECK(embree::closest_hits_directly(*witness, rays) == hits);
    CHECK(embree::any_hits_directly(*witness, rays) == hits);
  }
  const auto canonical = build_accelerator(Backend::bvh, share({}));
  CHECK_THROWS_AS(embree::any_hits_directly(*canonical, {}), Error);
}

TEST_CASE("packets and streams of embree-native find what its single rays find") {
  using embree::Call;
  const auto geometry = share({soup(300, 0.3f, 1), soup(300, 0.2f, 3)});
  // Debian's Embree 3.13 traces all rays of a packet with AVX2, and the active ones only with AVX-512, which
  // it chooses by default where the machine has it.
  const std::string isa = GENERATE(as<std::string>(), "avx2", "default");
  CAPTURE(isa);
  const auto witness = native(geometry, {.embree_isa = isa});
  std::vector<Ray> rays = random_rays(2003, geometry->bounds(), 4);  // The last packets are not full.
  for (std::size_t i = 0; i < rays.size(); i += 3) rays[i].t_max = 0.5f;
  std::vector<Hit> expected;
  for (const Ray& ray : rays) expected.push_back(witness->closest_hit(ray));
  const auto hits =
      std::size_t(std::count_if(expected.begin(), expected.end(), [](Hit hit) { return bool(hit); }));
  CHECK(hits > 500);
  CHECK(hits < 1500);
  for (const Call call : {Call::single, Call::packets, Call::stream, Call::packet_stream})
    for (const embree::Rays coherence : {embree::Rays::incoherent, embree::Rays::coherent}) {
      const embree::DirectCall how{call, coherence};
      CAPTURE(int(call), int(coherence));
      if (!embree::has(call)) {
        CHECK_THROWS_AS(embree::closest_hits_directly(*witness, rays, how), Error);
        CHECK_THROWS_AS(embree::any_hits_directly(*witness, rays, how), Error);
        continue;
      }
      for (const std::size_t count : {std::size_t(0), std::size_t(1), std::size_t(17), rays.size()}) {
        const std::span some = std::span(rays).first(count);
        std::vector<Hit> found(count);
        std::vector<std::uint8_t> blocked(count, 2);
        const std::size_t closest = embree::closest_hits_directly(*witness, some, how, found);
        const std::size_t any = embree::any_hits_directly(*witness, some, how, blocked);
        CHECK(embree::closest_hits_directly(*witness, some, how) == closest);
        CHECK(embree::any_hits_directly(*witness, some, how) == any);
        if (count == rays.size()) CHECK(closest == hits);
        CHECK(any == closest);
        for (std::size_t i = 0; i < count; ++i) {
          REQUIRE(bool(found[i]) == bool(expected[i]));
          REQUIRE(blocked[i] == std::uint8_t(bool(expected[i])));
          if (!found[i]) continue;
          REQUIRE(found[i].mesh == expected[i].mesh);
          REQUIRE(found[i].primitive == expected[i].primitive);
          REQUIRE(found[i].t == Approx(expected[i].t).margin(t_tolerance));
          REQUIRE(found[i].u == Approx(expected[i].u).margin(0.01));
          REQUIRE(found[i].v == Approx(expected[i].v).margin(0.01));
        }
      }
    }
}

TEST_CASE("packets and streams of embree-native are not for spheres") {
  const auto witness = native(share({random_spheres(2, 1, 1)}));
  CHECK(embree::has(embree::Call::single));
  CHECK(embree::has(embree::Call::packets));
  for (const embree::Call call : {embree::Call::packets, embree::Call::stream, embree::Call::packet_stream}) {
    CHECK_THROWS_AS(embree::closest_hits_directly(*witness, {}, {call}), Error);
    CHECK_THROWS_AS(embree::any_hits_directly(*witness, {}, {call}), Error);
  }
}

TEST_CASE("embree-native gives a sphere's canonical hit") {
  const auto geometry = share({random_spheres(50, 0.3f, 5)});
  const auto canonical = build_accelerator(Backend::brute_force, geometry);
  const auto witness = native(geometry);
  for (const Ray& ray : random_rays(2000, geometry->bounds(), 6)) {
    REQUIRE(witness->closest_hit(ray) == canonical->closest_hit(ray));
    REQUIRE(witness->any_hit(ray) == canonical->any_hit(ray));
  }
}

TEST_CASE("embree-native runs in both modes and with every instruction set") {
  const auto geometry = share({icosphere_mesh(3)});
  const Ray ray{.origin = {0.1f, 0.2f, 3}, .direction = {0, 0, -1}};
  for (const EmbreeMode mode : {EmbreeMode::robust, EmbreeMode::fast})
    for (const char* isa : {"sse2", "sse4.2", "avx", "avx2", "avx512", "default"}) {
      CAPTURE(isa);
      const auto witness = native(geometry, {.threads = 1, .embree_mode = mode, .embree_isa = isa});
      CHECK(witness->closest_hit(ray).t == Approx(2.025).margin(0.01));
    }
}

TEST_CASE("Embree's quality high splits triangles in fast mode") {
  const auto geometry = share({soup(3000, 1.0f, 9)});
  const auto bytes = [&](EmbreeMode mode, EmbreeQuality quality) {
    return native(geometry, {.threads = 1, .embree_mode = mode, .embree_quality = quality})->stats().bytes;
  };
  CHECK(bytes(EmbreeMode::fast, EmbreeQuality::high) > bytes(EmbreeMode::fast, EmbreeQuality::medium));
  const auto canonical = build_accelerator(Backend::bvh, geometry);
  const auto witness = native(geometry, {.threads = 1, .embree_quality = EmbreeQuality::high});
  for (const Ray& ray : random_rays(500, geometry->bounds(), 10))
    REQUIRE(bool(witness->closest_hit(ray)) == bool(canonical->closest_hit(ray)));
}

TEST_CASE("embree's leaf has the bits of brute force with every instruction set") {
  const auto geometry = share({soup(300, 0.3f, 1), random_spheres(20, 0.2f, 2), soup(300, 0.2f, 3)});
  const auto oracle = build_accelerator(Backend::brute_force, geometry);
  const auto rays = random_rays(1000, geometry->bounds(), 4);
  for (const std::string& simd : available_instruction_sets()) {
    CAPTURE(simd);
    const auto embree = build_accelerator(Backend::embree, geometry, {.simd = simd});
    for (const Ray& ray : rays) {
      REQUIRE(embree->closest_hit(ray) == oracle->closest_hit(ray));
      REQUIRE(embree->any_hit(ray) == oracle->any_hit(ray));
    }
  }
  CHECK_THROWS_AS(build_accelerator(Backend::embree, geometry, {.simd = "mmx"}), Error);
}

TEST_CASE("an unknown instruction set is an error that lists the valid ones") {
  CHECK_THROWS_WITH(
      native(share({}), {.embree_isa = "avx3"}),
      "Embree has no instruction set \"avx3\"; valid are sse2, sse4.2, avx, avx2, avx512, default");
}

TEST_CASE("Embree builds geometry without primitives") {
  for (const Backend backend : {Backend::embree, Backend::embree_native})
    for (const auto& geometry : {share({}), share({Mesh{}, SphereSet{}})}) {
      const auto accelerator = build_accelerator(backend, geometry);
      CHECK(!accelerator->closest_hit({.origin = {}, .direction = {1, 0, 0}}));
      CHECK(!accelerator->any_hit({.origin = {}, .direction = {1, 0, 0}}));
    }
}

TEST_CASE("Embree reads no vertex beyond the last") {
  // The address sanitizer watches: vertices fill their array to its end.
  for (const int count : {1, 4, 5, 16}) {
    const auto geometry = share({soup(count, 1, 7)});
    const auto canonical = build_accelerator(Backend::brute_force, geometry);
    const auto witness = native(geometry);
    int hits = 0, found = 0;
    for (const Ray& ray : random_rays(200, geometry->bounds(), 8)) {
      hits += canonical->any_hit(ray);
      found += witness->any_hit(ray);
    }
    CHECK(found == hits);
  }
}

TEST_CASE("Embree's memory and build time are reported") {
  const auto geometry = share({icosphere_mesh(4)});
  for (const Backend backend : {Backend::embree, Backend::embree_native}) {
    const AccelStats stats = build_accelerator(backend, geometry)->stats();
    CHECK(stats.primitives == geometry->primitive_count());
    CHECK(stats.bytes > 16 * geometry->primitive_count());
    CHECK(stats.phases.back().name == "embree");
  }
}

TEST_CASE("embree counts the primitives that its leaves test") {
  const auto geometry = share({soup(500, 0.1f, 9)});
  const auto embree = build_accelerator(Backend::embree, geometry);
  QueryCounts counts;
  for (const Ray& ray : random_rays(500, geometry->bounds(), 10))
    CHECK(embree->closest_hit({ray, &counts}) == embree->closest_hit(ray));
  CHECK(counts.leaves > 0);
  CHECK(counts.primitives >= counts.leaves);
  CHECK(counts.primitives <= 4 * counts.leaves);
  CHECK(counts.primitives < 500 * 500 / 10);
}

TEST_CASE("Embree is told of each hit, and culls by it as our own tree does") {
  // Layers one behind the other, of which a ray's nearest hit leaves most unseen. How many leaves Embree
  // looks at depends on its version; not told of a hit, it looks at all along the ray.
  Mesh mesh;
  for (int i = 0; i < 400; ++i) {
    const float z = float(i);
    add_triangle(mesh, {-400, -400, z}, {800, -400, z}, {-400, 800, z});
  }
  const auto geometry = share({mesh});
  const auto embree = build_accelerator(Backend::embree, geometry);
  QueryCounts closest, any;
  constexpr int rays = 100;
  for (int i = 0; i < rays; ++i) {
    const Ray ray{.origin = {float(i % 10), float(i / 10), -1}, .direction = {0.1f, 0.2f, 1}};
    CHECK(embree->closest_hit({ray, &closest}));
    CHECK(embree->any_hit({ray, &any}));
  }
  CHECK(closest.leaves < 4 * rays);
  CHECK(any.leaves == rays);
}

TEST_CASE("embree's blocks are nearly full") {
  const auto geometry = share({icosphere_mesh(4)});
  const auto embree = build_accelerator(Backend::embree, geometry);
  QueryCounts counts;
  for (const Ray& ray : random_rays(500, geometry->bounds(), 10)) embree->closest_hit({ray, &counts});
  REQUIRE(counts.leaves > 500);
  CHECK(double(counts.primitives) > 3.5 * double(counts.leaves));
}
