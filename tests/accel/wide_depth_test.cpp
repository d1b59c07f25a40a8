// SPDX-License-Identifier: Apache-2.0
// How deep an eight-wide BVH may be, and that the stacks of its queries are for trees of that depth.
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "accel/wide/invariants.h"
#include "accel/wide/kernel.h"
#include "tests/support/catch.h"
#include "tests/support/random.h"
#include "tests/support/shapes.h"
#include "tests/support/wide_engine.h"

using namespace twinray;
using namespace twinray::test;

TEST_CASE("no wide tree is deeper than its stack, and the deepest is traversed") {
  // Triangles whose distance from the origin doubles from one to the next, through 160 powers of two.
  Mesh mesh;
  for (int i = -120; i < 39; ++i) {
    const float x = std::ldexp(1.0f, i);
    add_triangle(mesh, {x, 0, 0}, {x, x, 0}, {x, 0, x});
  }
  const auto geometry = share({mesh});
  const BuildOptions options{.bvh_split = BvhSplit::midpoint, .max_leaf_size = 1};
  const WideBvh bvh = build_wide(*geometry, options);
  CHECK(find_fault(bvh, *geometry) == "");
  for (const WideKernel& kernel : wide_kernels()) {
    CAPTURE(kernel.name);
    CHECK(kernel.closest(bvh, *geometry, {.origin = {}, .direction = {1, 0.25f, 0.25f}}).primitive == 0);
    CHECK(!kernel.any(bvh, *geometry, {.origin = {-1, -1, -1}, .direction = {0, 1, 0}}));
  }
}

TEST_CASE("a wide tree that is one level too deep has a fault") {
  Mesh mesh;
  add_triangle(mesh, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const auto geometry = share({mesh});
  for (const int levels : {max_wide_depth, max_wide_depth + 1}) {
    WideBvh bvh;
    bvh.root = WideRef::node(0);
    for (int i = 0; i < levels; ++i) {
      WideNode node;
      for (int child = 0; child < 2; ++child) node.set_box(child, geometry->bounds());
      node.children[0] = i + 1 < levels ? WideRef::node(std::size_t(i) + 1) : WideRef::block(0);
      node.children[1] = WideRef::block(0);
      bvh.nodes.push_back(node);
    }
    bvh.blocks.push_back(make_block(*geometry, std::vector<PrimitiveId>{{0, 0}}));
    const std::string fault = find_fault(bvh, *geometry);
    CAPTURE(fault);
    CHECK((fault.find("deep") != std::string::npos) == (levels > max_wide_depth));
  }
}

TEST_CASE("a stack holds all siblings of the deepest path, whose nodes are full, in batches too") {
  Mesh mesh;
  add_triangle(mesh, {9, 0, 0}, {9, 1, 0}, {9, 0, 1});
  const auto geometry = share({mesh});
  const std::vector<PrimitiveId> ids{{0, 0}};
  WideBvh bvh;
  bvh.root = WideRef::node(0);
  bvh.blocks.push_back(make_block(*geometry, ids));
  for (int depth = 0; depth < max_wide_depth; ++depth) {
    // The nearest and first child goes deeper; seven blocks wait behind it.
    WideNode node;
    for (int child = 0; child < WideNode::width; ++child) {
      node.set_box(child, {{child == 0 ? 0.0f : float(child), -1, -1}, {10, 2, 2}});
      node.children[child] = WideRef::block(0);
    }
    if (depth + 1 < max_wide_depth) node.children[0] = WideRef::node(std::size_t(depth) + 1);
    bvh.nodes.push_back(node);
  }
  Random random(3);
  std::vector<Ray> rays;
  for (int i = 0; i < 100; ++i)
    rays.push_back({.origin = {-1, random.unit(), random.unit()}, .direction = {1, 0, 0}});
  for (const WideKernel& kernel : wide_kernels()) {
    CAPTURE(kernel.name);
    std::vector<Hit> hits(rays.size());
    std::vector<std::uint8_t> blocked(rays.size());
    kernel.closest_batch(bvh, *geometry, rays, hits.data());
    kernel.any_batch(bvh, *geometry, rays, blocked.data());
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const bool is_hit = rays[i].origin.y + rays[i].origin.z < 1;
      REQUIRE(hits[i].is_miss() != is_hit);
      REQUIRE(bool(blocked[i]) == is_hit);
      REQUIRE(kernel.closest(bvh, *geometry, rays[i]) == hits[i]);
      REQUIRE(kernel.any(bvh, *geometry, rays[i]) == is_hit);
    }
  }
}
