// SPDX-License-Identifier: Apache-2.0
// The eight-wide BVH in little memory. That its hits have the canonical bits is shown beside those of all
// other engines (tests/support/agreement.h).
#include <cstring>
#include <memory>
#include <vector>

#include "accel/canonical/slab.h"
#include "accel/compact/partition.h"
#include "accel/wide/invariants.h"
#include "accel/wide/scalar.h"
#include "core/error.h"
#include "io/generated/generated.h"
#include "tests/support/catch.h"
#include "tests/support/cut_outs.h"
#include "tests/support/instances.h"
#include "tests/support/shapes.h"
#include "tests/support/wide_engine.h"

using namespace twinray;
using namespace twinray::test;

namespace {

/// A node of `count` random boxes of any size, some of them flat, some points.
WideNode random_tight_node(Random& random, int count) {
  WideNode node;
  const float extent = random.below(4) == 0 ? 1e12f : random.below(2) ? 1 : 1e-12f;
  const Vec3 middle = random.in_cube(random.below(3) == 0 ? 0 : 1);
  for (int child = 0; child < count; ++child) {
    Aabb box;
    box.extend(middle + random.in_cube(extent));
    box.extend(middle + random.in_cube(extent));
    if (random.below(4) == 0) box.lower[child % 3] = box.upper[child % 3];
    if (random.below(9) == 0) box.lower = box.upper;
    node.set_box(child, padded(box));
    node.children[child] = WideRef::block(std::size_t(child));
  }
  return node;
}

bool same_trees(const CompactBvh& a, const CompactBvh& b) {
  return a.root == b.root && a.nodes.size() == b.nodes.size() && a.blocks == b.blocks &&
         std::memcmp(a.nodes.data(), b.nodes.data(), a.nodes.size() * sizeof(CompactNode)) == 0;
}

std::shared_ptr<const Geometry> ball(std::size_t triangles) {
  return generated::make_ball(triangles).geometry;
}

int depth_of(const BuildTree& tree, std::uint32_t node = 0) {
  const BuildTree::Node& at = tree.nodes[node];
  return at.count > 0 ? 0 : 1 + std::max(depth_of(tree, at.first), depth_of(tree, at.first + 1));
}

}  // namespace

TEST_CASE("a compact node's boxes contain those of the ordinary one, and are at most a step larger") {
  Random random(3);
  for (int i = 0; i < 20000; ++i) {
    CAPTURE(i);
    const WideNode node = random_tight_node(random, 2 + random.below(7));
    const CompactNode compact(node);
    REQUIRE(compact.count() == node.count());
    for (int child = 0; child < node.count(); ++child) {
      const Aabb box = node.box(child), rounded = compact.box(child);
      REQUIRE(rounded.contains(box));
      REQUIRE(compact.children[child] == node.children[child]);
      for (int axis = 0; axis < 3; ++axis) {
        // A step, and the rounding of a plane.
        const double most =
            1.001 * compact.grids[axis].step + 1e-6 * max_abs(rounded.lower) + 1e-6 * max_abs(rounded.upper);
        REQUIRE(double(box.lower[axis]) - rounded.lower[axis] <= most);
        REQUIRE(double(rounded.upper[axis]) - box.upper[axis] <= most);
      }
    }
  }
}

TEST_CASE("every compact tree holds all primitives, in one part and in many") {
  const auto spheres_and_triangles =
      share({soup(700, 0.1f, 1), random_spheres(60, 0.2f, 2), soup(300, 1.0f, 3)});
  const auto holes = share_cut_out({soup(300, 0.2f, 4), soup(300, 0.2f, 5)}, {random_alpha(1)});
  for (const auto& geometry : {spheres_and_triangles, holes, ball(5000)})
    for (const std::size_t least : {std::size_t{4}, std::size_t{100}, least_part})
      for (const BvhSplit split : {BvhSplit::sah, BvhSplit::median, BvhSplit::midpoint, BvhSplit::mean}) {
        CAPTURE(least, int(split));
        CHECK(find_fault(build_compact(*geometry, {.bvh_split = split}, least), *geometry) == "");
      }
  for (const BvhBuilder builder : available_builders()) {
    const auto occurrence = builder == BvhBuilder::embree_high ? Occurrence::in_pieces : Occurrence::once;
    const CompactBvh bvh = build_compact(*spheres_and_triangles, {.bvh_builder = builder}, 50);
    CHECK(find_fault(bvh, *spheres_and_triangles, occurrence) == "");
  }
  for (const auto& geometry : degenerate_geometries())
    CHECK(find_fault(build_compact(*geometry), *geometry) == "");
}

TEST_CASE("the invariants find a primitive that a compact tree has lost, and a box that is too small") {
  const auto geometry = ball(5000);
  const CompactBvh good = build_compact(*geometry);
  CompactBvh bad = good;
  for (std::uint8_t& plane : bad.nodes.back().planes[0][1]) plane = 0;
  CHECK(find_fault(bad, *geometry) != "");
  bad = good;
  bad.blocks[4] += 1;  // Of the first block the least index of a primitive.
  CHECK(find_fault(bad, *geometry) != "");
}

TEST_CASE("a compact tree over instances holds each once") {
  const auto geometry = share_instanced({soup(200, 0.3f, 1)}, {{soup(100, 0.2f, 2)}, {soup(3, 0.2f, 3)}},
                                        {Kind::rigid, Kind::mirrored}, 50, 4);
  CHECK(find_fault(build_compact(*geometry), *geometry) == "");
}

TEST_CASE("the compact tree has the same bits on any number of threads") {
  const auto geometry = share({soup(40000, 0.02f, 7)});
  const CompactBvh one = build_compact(*geometry, {.threads = 1}, 1000);
  CHECK(same_trees(one, build_compact(*geometry, {.threads = 2}, 1000)));
  CHECK(same_trees(one, build_compact(*geometry, {.threads = 7}, 1000)));
}

TEST_CASE("parts are a sixteenth of all primitives at most, and lie no deeper than a stack has room for") {
  // Triangles whose distance from the origin doubles from one to the next: each split takes one of them away.
  Mesh mesh;
  for (int i = -110; i < 39; ++i)
    for (int k = 0; k < 3; ++k) {
      const float x = std::ldexp(1.0f + 0.1f * float(k), i);
      add_triangle(mesh, {x, 0, 0}, {x, x, 0}, {x, 0, x});
    }
  for (const auto& geometry : {share({mesh}), share({soup(5000, 0.1f, 1)})})
    for (const BvhSplit split : {BvhSplit::sah, BvhSplit::midpoint}) {
      BuildPrimitives primitives = collect_primitives(*geometry, geometry->direct_shapes());
      const std::size_t all = primitives.size();
      const Partition parts = partition(primitives, {.bvh_split = split}, 4);
      CHECK(depth_of(parts.tree) <= max_part_depth);
      std::size_t next = 0;
      for (const Partition::Part& part : parts.parts) {
        CHECK(part.first == next);
        CHECK(part.count <= (all + 15) / 16);
        CHECK(part.count > 0);
        next += part.count;
      }
      CHECK(next == all);
    }
}

TEST_CASE("walls of a room are parts of their own, each with the triangles of its rectangle") {
  const auto geometry = ball(20000);  // In a room of six walls, and below a lamp: seven rectangles.
  BuildPrimitives primitives = collect_primitives(*geometry, geometry->direct_shapes());
  const Partition parts = partition(primitives, BuildOptions{}, 1000);
  std::size_t rectangles = 0;
  for (const Partition::Part& part : parts.parts) {
    const std::span<const BuildPrimitive> within(&primitives[part.first], part.count);
    const bool has_wall = std::any_of(within.begin(), within.end(), [](const BuildPrimitive& p) {
      return max_abs(p.box.extent()) > 1;  // The ball's triangles are smaller, as is the lamp's side.
    });
    rectangles += part.count == 2;
    if (!has_wall) continue;
    REQUIRE(part.count == 2);
    CHECK(within[0].box == within[1].box);
  }
  CHECK(rectangles >= 7);
}

TEST_CASE("nodes above the parts are full, and few primitives need none") {
  const auto geometry = share({soup(20000, 0.01f, 1)});
  BuildPrimitives primitives = collect_primitives(*geometry, geometry->direct_shapes());
  // Sixteen to 32 would do; but then the second of two levels would be half empty.
  const std::size_t parts = partition(primitives, BuildOptions{}, 1000).parts.size();
  CHECK(parts > 40);
  CHECK(parts <= 64);
  CHECK(partition(primitives, BuildOptions{}, 20000).parts.size() == 1);
}

TEST_CASE("a tree that was built in parts takes few more steps than one that was built as a whole") {
  for (const auto& geometry : {ball(20000), share({soup(20000, 0.05f, 1)})}) {
    const CompactBvh whole = build_compact(*geometry, {}, geometry->primitive_count());
    const CompactBvh parts = build_compact(*geometry, {}, 1000);
    QueryCounts of_whole, of_parts;
    for (const Ray& ray : random_rays(2000, geometry->bounds(), 3)) {
      const Hit hit = scalar_closest(whole, *geometry, ray, of_whole);
      REQUIRE(hit == scalar_closest(parts, *geometry, ray, of_parts));
    }
    INFO(of_whole.nodes << " and " << of_parts.nodes);
    CHECK(double(of_parts.nodes) < 1.1 * double(of_whole.nodes));
    CHECK(double(of_parts.leaves) < 1.2 * double(of_whole.leaves));
  }
}

TEST_CASE("a part is taken with its bits, and the rest stays as it was") {
  const auto geometry = share({soup(3000, 0.1f, 1)});
  BuildPrimitives primitives = collect_primitives(*geometry, geometry->direct_shapes());
  const BuildPrimitives before = primitives;
  const BuildPrimitives taken = take_part(primitives, {1000, 1000});
  REQUIRE(taken.size() == 1000);
  CHECK(std::memcmp(taken.data(), &before[1000], 1000 * sizeof(BuildPrimitive)) == 0);
  CHECK(std::memcmp(primitives.data(), before.data(), 1000 * sizeof(BuildPrimitive)) == 0);
  CHECK(std::memcmp(&primitives[2000], &before[2000], 1000 * sizeof(BuildPrimitive)) == 0);
}

TEST_CASE("a compact tree of a mesh takes half the memory of the ordinary one") {
  const auto geometry = ball(100000);
  const auto bytes = [&](MemoryMode mode) {
    const auto engine = build_accelerator(Backend::bvh, geometry, {.memory_mode = mode});
    return double(engine->stats().bytes) / double(geometry->primitive_count());
  };
  CHECK(bytes(MemoryMode::compact) < bytes(MemoryMode::ordinary) / 1.9);
}

TEST_CASE("a compact tree's queries take few more steps than the ordinary one's") {
  const auto geometry = ball(20000);
  const CompactBvh compact(build_wide(*geometry));
  const WideBvh ordinary = build_wide(*geometry);
  QueryCounts of_compact, of_ordinary;
  for (const Ray& ray : random_rays(2000, geometry->bounds(), 3)) {
    const Hit hit = scalar_closest(compact, *geometry, ray, of_compact);
    REQUIRE(hit == scalar_closest(ordinary, *geometry, ray, of_ordinary));
  }
  CHECK(of_compact.nodes >= of_ordinary.nodes);
  CHECK(double(of_compact.nodes) < 1.1 * double(of_ordinary.nodes));
  CHECK(double(of_compact.primitives) < 1.3 * double(of_ordinary.primitives));
}

TEST_CASE("the fast kernels take the steps of the scalar traversal in a compact tree, too") {
  for (const auto& geometry : {share({soup(3000, 0.2f, 1), random_spheres(40, 0.2f, 2)}), ball(5000)}) {
    const CompactBvh bvh = build_compact(*geometry);
    std::vector<Ray> rays = random_rays(1000, geometry->bounds(), 3);
    for (std::size_t i = 0; i < rays.size(); i += 3) rays[i].t_max = 0.5f;
    QueryCounts closest, any;
    for (const Ray& ray : rays) {
      scalar_closest(bvh, *geometry, ray, closest);
      scalar_any(bvh, *geometry, ray, any);
    }
    for (const CountingCompactKernel& kernel : counting_compact_kernels()) {
      CAPTURE(kernel.name);
      QueryCounts of_single, of_many;
      std::vector<Hit> hits(rays.size());
      for (const Ray& ray : rays) kernel.closest(bvh, *geometry, ray, of_single);
      kernel.closest_batch(bvh, *geometry, rays, hits.data(), of_many);
      for (const QueryCounts& counts : {of_single, of_many}) {
        CHECK(counts.nodes == closest.nodes);
        CHECK(counts.boxes == closest.boxes);
        CHECK(counts.leaves == closest.leaves);
        CHECK(counts.primitives == closest.primitives);
      }
      QueryCounts of_any;
      for (const Ray& ray : rays) kernel.any(bvh, *geometry, ray, of_any);
      CHECK(of_any.nodes == any.nodes);
      CHECK(of_any.primitives == any.primitives);
    }
  }
}

TEST_CASE("every kernel tests the boxes of a compact node with the bits of the canonical box test") {
  Random random(6);
  for (int i = 0; i < 20000; ++i) {
    const CompactNode node(random_tight_node(random, 2 + random.below(7)));
    CheckedRay ray;
    Ray given{.origin = random.in_cube(2), .direction = random.in_cube()};
    if (random.below(3) == 0) given.direction[random.below(3)] = 0;
    REQUIRE(load_ray(given, ray));
    float expected[WideNode::width];
    const std::uint32_t met = intersect_children(node, ray, ray.t_max, expected);
    for (const CompactKernel& kernel : compact_kernels()) {
      float entries[WideNode::width];
      REQUIRE(kernel.intersect_children(node, ray, ray.t_max, entries) == met);
      for (int child = 0; child < WideNode::width; ++child)
        if (met >> child & 1) REQUIRE(std::memcmp(&entries[child], &expected[child], sizeof(float)) == 0);
    }
  }
}
