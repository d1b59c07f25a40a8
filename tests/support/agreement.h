// SPDX-License-Identifier: Apache-2.0
// Every canonical engine against brute force, bit for bit.
#pragma once
#include <bit>
#include <memory>
#include <string>
#include <vector>

#include "accel/accelerator.h"
#include "tests/support/catch.h"
#include "tests/support/wide_engine.h"

namespace twinray::test {

using Rays = std::vector<Ray>;

inline bool same_bits(const Hit& a, const Hit& b) {
  const auto bits = [](float x) { return std::bit_cast<std::uint32_t>(x); };
  return bits(a.t) == bits(b.t) && bits(a.u) == bits(b.u) && bits(a.v) == bits(b.v) &&
         a.primitive == b.primitive && a.mesh == b.mesh && a.instance == b.instance;
}

struct LabelledEngine {
  std::string label;
  std::unique_ptr<Accelerator> accelerator;
};

/// Every engine that promises canonical bits, but brute force.
inline std::vector<LabelledEngine> canonical_engines(const std::shared_ptr<const Geometry>& geometry) {
  std::vector<LabelledEngine> engines;
  const auto add = [&](const std::string& label, Backend backend, const BuildOptions& options) {
    engines.push_back({label, build_accelerator(backend, geometry, options)});
  };
  add("bvh sah", Backend::bvh, {.bvh_width = 2});
  add("bvh sah, leaves of 1", Backend::bvh, {.bvh_width = 2, .max_leaf_size = 1});
  add("bvh sah, leaves of 9", Backend::bvh, {.bvh_width = 2, .max_leaf_size = 9, .traversal_cost = 4});
  add("bvh median", Backend::bvh, {.bvh_width = 2, .bvh_split = BvhSplit::median, .max_leaf_size = 2});
  add("bvh midpoint", Backend::bvh, {.bvh_width = 2, .bvh_split = BvhSplit::midpoint, .max_leaf_size = 1});
  add("bvh mean", Backend::bvh, {.bvh_width = 2, .bvh_split = BvhSplit::mean});
  for (const BvhBuilder builder : available_builders())
    for (const int leaf : {1, 4})
      if (builder != BvhBuilder::own)
        add("bvh " + builder_name(builder), Backend::bvh,
            {.bvh_width = 2, .bvh_builder = builder, .max_leaf_size = leaf});
  add("bvh 8-wide, leaves of 1", Backend::bvh, {.bvh_width = 8, .max_leaf_size = 1});
  add("bvh 8-wide fast", Backend::bvh, {.bvh_quality = BvhQuality::fast});
  add("bvh 8-wide high", Backend::bvh, {.bvh_quality = BvhQuality::high});
  add("bvh 8-wide median", Backend::bvh, {.bvh_width = 8, .bvh_split = BvhSplit::median});
  const WideTrees trees = geometry->has_instances() ? WideTrees::instanced : WideTrees::plain;
  for (const WideKernel& kernel : wide_kernels(trees))
    engines.push_back({"bvh 8-wide, " + kernel.name, wide_engine(geometry, kernel)});
  add("bvh compact", Backend::bvh, {.memory_mode = MemoryMode::compact});
  for (const CompactKernel& kernel : compact_kernels(trees))
    engines.push_back({"bvh compact, " + kernel.name, compact_engine(geometry, kernel)});
#ifdef TWINRAY_WITH_EMBREE
  for (const char* isa : {"sse2", "sse4.2", "avx", "avx2", "avx512", "default"})
    add(std::string("embree ") + isa, Backend::embree, {.threads = 1, .embree_isa = isa});
#endif
  return engines;
}

/// Checks all engines against brute force; returns how many rays hit.
inline int check_agreement(const std::shared_ptr<const Geometry>& geometry, const Rays& rays) {
  const auto oracle = build_accelerator(Backend::brute_force, geometry);
  std::vector<Hit> expected;
  int hits = 0;
  for (const Ray& ray : rays) {
    expected.push_back(oracle->closest_hit(ray));
    hits += bool(expected.back());
    REQUIRE(oracle->any_hit(ray) == bool(expected.back()));
  }
  for (const LabelledEngine& engine : canonical_engines(geometry)) {
    CAPTURE(engine.label);
    int differing = 0;
    std::vector<Hit> batch(rays.size());
    std::vector<std::uint8_t> any_batch(rays.size());
    engine.accelerator->closest_hits(rays, batch);
    engine.accelerator->any_hits(rays, any_batch);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const bool is_hit(expected[i]);
      const bool same = same_bits(engine.accelerator->closest_hit(rays[i]), expected[i]) &&
                        engine.accelerator->any_hit(rays[i]) == is_hit && same_bits(batch[i], expected[i]) &&
                        bool(any_batch[i]) == is_hit;
      if (!same && ++differing == 1) {
        CAPTURE(i, expected[i].t, expected[i].instance, expected[i].mesh, expected[i].primitive);
        CHECK(same);
      }
    }
    CHECK(differing == 0);
  }
  return hits;
}

}  // namespace twinray::test
