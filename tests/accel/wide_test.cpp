// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstring>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "accel/wide/collapse.h"
#include "accel/wide/invariants.h"
#include "accel/wide/scalar.h"
#include "core/error.h"
#include "tests/support/catch.h"
#include "tests/support/shapes.h"
#include "tests/support/wide_engine.h"

using namespace twinray;
using namespace twinray::test;

namespace {

constexpr BvhSplit all_splits[] = {BvhSplit::sah, BvhSplit::median, BvhSplit::midpoint, BvhSplit::mean};

constexpr BvhQuality all_qualities[] = {BvhQuality::fast, BvhQuality::medium, BvhQuality::high};

std::string fault(const Geometry& geometry, const BuildOptions& options = {}) {
  return find_fault(build_wide(geometry, options), geometry);
}

bool same_trees(const WideBvh& a, const WideBvh& b) {
  const auto same_node = [](const WideNode& x, const WideNode& y) {
    return std::memcmp(x.planes, y.planes, sizeof x.planes) == 0 &&
           std::equal(std::begin(x.children), std::end(x.children), std::begin(y.children));
  };
  const auto same_block = [](const PrimitiveBlock& x, const PrimitiveBlock& y) {
    return std::memcmp(x.corners, y.corners, sizeof x.corners) == 0 &&
           std::memcmp(x.ids, y.ids, sizeof x.ids) == 0 && x.count == y.count && x.triangles == y.triangles;
  };
  return a.root == b.root &&
         std::equal(a.nodes.begin(), a.nodes.end(), b.nodes.begin(), b.nodes.end(), same_node) &&
         std::equal(a.blocks.begin(), a.blocks.end(), b.blocks.begin(), b.blocks.end(), same_block);
}

/// A node of `count` random boxes, some of them flat, some far away.
WideNode random_node(Random& random, int count) {
  WideNode node;
  for (int child = 0; child < count; ++child) {
    const float size = random.below(4) == 0 ? 1e12f : 1;
    Aabb box;
    box.extend(random.in_cube(size));
    box.extend(random.in_cube(size));
    if (random.below(4) == 0) box.lower[child % 3] = box.upper[child % 3];
    node.set_box(child, padded(box));
    node.children[child] = WideRef::block(std::size_t(child));
  }
  return node;
}

/// Rays with zeros of both signs, from inside and outside of the unit cube, some of them short or far off.
Ray random_ray(Random& random) {
  Ray ray{.origin = random.in_cube(2), .direction = random.in_cube()};
  if (random.below(3) == 0) ray.direction[random.below(3)] = random.below(2) ? -0.0f : 0.0f;
  if (random.below(3) == 0) ray.origin = ray.origin * 1e7f;
  ray.t_min = random.below(2) ? -0.0f : random.unit();
  if (random.below(2)) ray.t_max = ray.t_min + random.unit() * 2;
  return ray;
}

/// The least cost of a binary subtree: over every cut through it, by trying all.
class Exhaustive {
 public:
  Exhaustive(const BuildTree& tree, const CollapsePlan& plan) : tree_(tree), plan_(plan) {}

  double least_cost(std::uint32_t node) const {
    double cost = std::numeric_limits<double>::infinity();
    if (primitives(node) <= 4) cost = CollapsePlan::leaf_cost * plan_.probability(node);
    if (tree_.nodes[node].count > 0) return cost;
    const double inner = CollapsePlan::node_cost * plan_.probability(node);
    const std::uint32_t child = tree_.nodes[node].first;
    return std::min(cost, inner + least_cut({child, child + 1}, 0));
  }

 private:
  using Cut = std::vector<std::uint32_t>;

  /// Of the cuts that keep the first `fixed` nodes of this one.
  double least_cut(Cut cut, std::size_t fixed) const {
    double least = 0;
    for (const std::uint32_t node : cut) least += least_cost(node);
    if (cut.size() == WideNode::width) return least;
    for (std::size_t i = fixed; i < cut.size(); ++i) {
      const BuildTree::Node& node = tree_.nodes[cut[i]];
      if (node.count > 0) continue;
      Cut finer = cut;
      finer[i] = node.first;
      finer.push_back(node.first + 1);
      least = std::min(least, least_cut(finer, i));
    }
    return least;
  }
  std::uint32_t primitives(std::uint32_t node) const {
    const BuildTree::Node& n = tree_.nodes[node];
    return n.count > 0 ? n.count : primitives(n.first) + primitives(n.first + 1);
  }

  const BuildTree& tree_;
  const CollapsePlan& plan_;
};

/// The cost of the tree that the plan makes.
double planned_cost(const CollapsePlan& plan, std::uint32_t node) {
  if (plan.is_leaf(node)) return CollapsePlan::leaf_cost * plan.probability(node);
  double cost = CollapsePlan::node_cost * plan.probability(node);
  const CollapsePlan::Children children = plan.children(node);
  for (int child = 0; child < children.count; ++child) cost += planned_cost(plan, children.nodes[child]);
  return cost;
}

}  // namespace

TEST_CASE("every split and leaf size gives a wide tree without a fault") {
  const auto geometry = share({soup(700, 0.1f, 1), random_spheres(60, 0.2f, 2), soup(300, 1.0f, 3)});
  for (const BvhSplit split : all_splits)
    for (const int leaf : {1, 2, 3, 4, 5, 255}) {
      CAPTURE(int(split), leaf);
      CHECK(fault(*geometry, {.bvh_split = split, .max_leaf_size = leaf}) == "");
    }
  for (const BvhBuilder builder : available_builders())
    for (const BvhQuality quality : all_qualities) {
      const auto occurrence = builder == BvhBuilder::embree_high ? Occurrence::in_pieces : Occurrence::once;
      const WideBvh bvh = build_wide(*geometry, {.bvh_builder = builder, .bvh_quality = quality});
      CHECK(find_fault(bvh, *geometry, occurrence) == "");
    }
}

TEST_CASE("a wide tree's leaves hold no more than the largest leaf size") {
  const auto geometry = share({soup(500, 0.1f, 1)});
  for (const int leaf : {1, 2, 3, 4}) {
    const WideBvh bvh = build_wide(*geometry, {.max_leaf_size = leaf, .traversal_cost = 10});
    std::uint32_t largest = 0;
    for (const PrimitiveBlock& block : bvh.blocks) largest = std::max(largest, std::uint32_t(block.count));
    CHECK(largest == std::uint32_t(leaf));
  }
}

TEST_CASE("the invariants name what is wrong with a wide tree") {
  const auto geometry = share({soup(60, 1, 1)});
  const WideBvh good = build_wide(*geometry);
  REQUIRE(good.nodes.size() > 1);
  CHECK(find_fault(good, *geometry) == "");

  WideBvh bad = good;
  bad.nodes.back().planes[0][0][0] = -10;
  CHECK(find_fault(bad, *geometry).find("leaves its parent") != std::string::npos);
  bad = good;
  bad.blocks[0].ids[0].primitive = 60;
  CHECK(find_fault(bad, *geometry) == "there is no primitive 60 of shape 0");
  bad = good;
  bad.blocks[0].ids[0] = bad.blocks[1].ids[0];
  CHECK(find_fault(bad, *geometry) != "");
  bad = good;
  bad.blocks[0].count = 5;
  CHECK(find_fault(bad, *geometry) == "block 0 holds 5 primitives");
  bad = good;
  bad.nodes[0].children[0] = WideRef::node(good.nodes.size());
  CHECK(find_fault(bad, *geometry).find("is named, of") != std::string::npos);
  bad = good;
  bad.nodes[0].children[1] = {};
  CHECK(find_fault(bad, *geometry).find("node 0 has 1 children") == 0);
  bad = good;
  bad.root = WideRef::block(0);
  CHECK(find_fault(bad, *geometry) == "node 0 is found 0 times");
}

TEST_CASE("the wide tree has the same bits on any number of threads") {
  const auto geometry = share({soup(40000, 0.02f, 7)});
  for (const BvhSplit split : {BvhSplit::sah, BvhSplit::median})
    for (const BvhQuality quality : all_qualities) {
      const auto on = [&](int threads) {
        return build_wide(*geometry, {.threads = threads, .bvh_split = split, .bvh_quality = quality});
      };
      const WideBvh one = on(1);
      CHECK(same_trees(one, on(2)));
      CHECK(same_trees(one, on(7)));
    }
}

TEST_CASE("of the three qualities high gives the cheapest wide tree") {
  // Triangles in a box of large ones, as in a room: where greedy splits go wrong.
  Mesh mesh = soup(20000, 0.01f, 9);
  for (int axis = 0; axis < 3; ++axis)
    for (const float side : {-1.0f, 1.0f}) {
      Vec3 corners[4] = {{side, -1, -1}, {side, 1, -1}, {side, 1, 1}, {side, -1, 1}};
      for (Vec3& p : corners) std::swap(p.x, p[axis]);
      add_triangle(mesh, corners[0], corners[1], corners[2]);
      add_triangle(mesh, corners[0], corners[2], corners[3]);
    }
  const auto geometry = share({mesh});
  const auto cost = [&](BvhQuality quality) {
    return build_accelerator(Backend::bvh, geometry, {.bvh_quality = quality})->stats().tree->sah_cost;
  };
  CHECK(cost(BvhQuality::high) < cost(BvhQuality::medium));
  CHECK(cost(BvhQuality::high) < cost(BvhQuality::fast));
}

TEST_CASE("degenerate geometry builds a wide tree") {
  for (const auto& geometry : degenerate_geometries())
    for (const BvhSplit split : all_splits) {
      CAPTURE(geometry->primitive_count(), int(split));
      CHECK(fault(*geometry, {.bvh_split = split, .max_leaf_size = 2}) == "");
    }
}

TEST_CASE("the collapse costs the least of all") {
  for (const std::uint64_t seed : {1, 2, 3, 4, 5}) {
    const auto geometry = share({soup(13, seed % 2 ? 0.1f : 0.7f, seed)});
    const BuildTree tree =
        build_tree(collect_primitives(*geometry, geometry->direct_shapes()), {.max_leaf_size = 1});
    const CollapsePlan plan(tree, 4);
    constexpr double rounding = 1e-5;  // The plan adds in float.
    CHECK(plan.cost() == Approx(Exhaustive(tree, plan).least_cost(0)).epsilon(rounding));
    CHECK(plan.cost() == Approx(planned_cost(plan, 0)).epsilon(rounding));
  }
}

TEST_CASE("each kernel has the instruction set of its name, and the last one is scalar") {
  const std::set<std::string> names{"avx512", "avx2", "sse4", "neon", "scalar"};
  const std::vector<WideKernel> kernels = wide_kernels();
  for (const WideKernel& kernel : kernels) CHECK(names.count(kernel.name) == 1);
  CHECK(kernels.back().name == "scalar");
}

TEST_CASE(
    "the instruction set of a wide tree is chosen by name, and others are refused with the valid names") {
  const auto geometry = share({soup(50, 0.3f, 1)});
  const std::vector<std::string> names = available_instruction_sets();
  REQUIRE(names.size() == wide_kernels().size() + 1);
  CHECK(names.front() == "best");
  CHECK(names.back() == "scalar");
  std::string valid;
  for (const std::string& name : names) {
    valid += (valid.empty() ? "" : ", ") + name;
    CHECK(build_accelerator(Backend::bvh, geometry, {.bvh_width = 8, .simd = name}));
  }
  CHECK_THROWS_WITH(build_accelerator(Backend::bvh, geometry, {.bvh_width = 8, .simd = "AVX2"}),
                    "there is no instruction set \"AVX2\" on this machine; valid are " + valid);
}

TEST_CASE("a batch gives the bits of single rays, for every instruction set and any number of rays") {
  const auto geometry = share({soup(2000, 0.1f, 1), random_spheres(20, 0.2f, 2)});
  Random random(8);
  for (const WideKernel& kernel : wide_kernels()) {
    CAPTURE(kernel.name);
    const auto bvh = wide_engine(geometry, kernel);
    for (const int count : {0, 1, 7, 8, 31, 32, 33, 128, 1000}) {
      std::vector<Ray> rays;
      for (int i = 0; i < count; ++i) {
        rays.push_back(random_ray(random));
        if (random.below(10) == 0) rays.back().direction = {};                                // invalid
        if (random.below(10) == 0) rays.back().direction = rays.back().direction * 0x1p-50f;  // scaled
      }
      std::vector<Hit> hits(rays.size(), Hit{.t = 1});
      std::vector<std::uint8_t> blocked(rays.size(), 7);
      bvh->closest_hits(rays, hits);
      bvh->any_hits(rays, blocked);
      for (std::size_t i = 0; i < rays.size(); ++i) {
        REQUIRE(hits[i] == bvh->closest_hit(rays[i]));
        REQUIRE(blocked[i] == std::uint8_t(bvh->any_hit(rays[i])));
      }
    }
  }
}

TEST_CASE("a batch misses an empty tree, and misses with rays all of which are invalid") {
  const auto some = share({soup(50, 0.3f, 1)});
  for (const WideKernel& kernel : wide_kernels())
    for (const bool is_empty : {true, false}) {
      const auto bvh = wide_engine(is_empty ? share({}) : some, kernel);
      std::vector<Ray> rays(100, Ray{.origin = {}, .direction = {is_empty ? 1.0f : 0.0f, 0, 0}});
      std::vector<Hit> hits(rays.size(), Hit{.t = 1});
      std::vector<std::uint8_t> blocked(rays.size(), 7);
      bvh->closest_hits(rays, hits);
      bvh->any_hits(rays, blocked);
      for (const Hit& hit : hits) CHECK(hit.is_miss());
      for (const std::uint8_t is_blocked : blocked) CHECK(is_blocked == 0);
    }
}

TEST_CASE("every kernel tests eight boxes with the bits of the canonical box test") {
  const std::vector<WideKernel> kernels = wide_kernels();
  Random random(5);
  std::size_t met = 0, missed = 0;
  for (int i = 0; i < 20000; ++i) {
    const WideNode node = random_node(random, 2 + random.below(7));
    CheckedRay ray;
    REQUIRE(load_ray(random_ray(random), ray));
    for (const WideKernel& kernel : kernels) {
      float entries[WideNode::width];
      const std::uint32_t found = kernel.intersect_children(node, ray, ray.t_max, entries);
      for (int child = 0; child < WideNode::width; ++child) {
        const SlabInterval interval = intersect_slab(ray, node.box(child));
        const bool is_met = interval.near <= interval.far && interval.near <= ray.t_max &&
                            interval.far >= ray.t_min && child < node.count();
        if ((found >> child & 1) != is_met || !(entries[child] == std::max(interval.near, ray.t_min)))
          FAIL(kernel.name << " differs on child " << child << " of node " << i);
        (is_met ? met : missed) += 1;
      }
    }
  }
  CHECK(met > 4000 * kernels.size());
  CHECK(missed > 20000 * kernels.size());
}

TEST_CASE("a fast kernel never takes -0 for an entry, which its order would put last") {
  WideNode node;
  for (int child = 0; child < WideNode::width; ++child) {
    node.set_box(child, {{0, -1, -1}, {1, 1, 1}});
    node.children[child] = WideRef::block(std::size_t(child));
  }
  for (const WideKernel& kernel : wide_kernels()) {
    if (kernel.name == "scalar") continue;
    CheckedRay ray;
    REQUIRE(load_ray({.origin = {}, .direction = {-1, 0.5f, 0.5f}, .t_min = -0.0f}, ray));
    float entries[WideNode::width];
    CHECK(kernel.intersect_children(node, ray, ray.t_max, entries) == 0xff);
    for (const float entry : entries) CHECK((entry >= 0 && !std::signbit(entry)));
  }
}

TEST_CASE("counting changes no answer of a wide tree and counts what was done") {
  const auto geometry = share({soup(500, 0.2f, 1), random_spheres(20, 0.2f, 2)});
  const auto bvh = build_accelerator(Backend::bvh, geometry);
  QueryCounts closest, any;
  for (const Ray& ray : random_rays(500, geometry->bounds(), 4)) {
    CHECK(bvh->closest_hit({ray, &closest}) == bvh->closest_hit(ray));
    CHECK(bvh->any_hit({ray, &any}) == bvh->any_hit(ray));
  }
  CHECK(closest.boxes > 2 * closest.nodes);
  CHECK(closest.boxes <= 8 * closest.nodes);
  CHECK(closest.primitives >= closest.leaves);
  CHECK(closest.primitives <= 4 * closest.leaves);
  CHECK(any.nodes < closest.nodes);
}

TEST_CASE("a wide tree has statistics") {
  const auto geometry = share({soup(500, 0.2f, 1)});
  const AccelStats stats = build_accelerator(Backend::bvh, geometry)->stats();
  const WideBvh bvh = build_wide(*geometry);
  CHECK(stats.primitives == 500);
  CHECK(stats.tree->leaves == bvh.blocks.size());
  CHECK(stats.tree->nodes == bvh.nodes.size() + bvh.blocks.size());
  CHECK(stats.bytes == bvh.bytes());
  CHECK(stats.tree->depth > 2);
  CHECK(stats.tree->sah_cost > 1);
  REQUIRE(stats.phases.size() == 4);
  CHECK(stats.phases[2].name == "reinsertion");
  CHECK(stats.phases[3].name == "collapse");
}

TEST_CASE("the sah cost of a wide tree is the expected cost of a ray") {
  const auto cost = [](const Mesh& mesh, const BuildOptions& options) {
    return build_accelerator(Backend::bvh, share({mesh}), options)->stats().tree->sah_cost;
  };
  // Of one leaf, its primitives' costs.
  CHECK(cost(soup(1, 1, 1), {.intersection_cost = 3}) == 3);
  CHECK(cost(soup(4, 1, 1), {.traversal_cost = 1e6, .intersection_cost = 3}) == 12);
  // Flat boxes of area 1, 1 and 2 in one of 10 x 1: a node, and each leaf by its share of the area.
  Mesh mesh;
  add_triangle(mesh, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  add_triangle(mesh, {3, 0, 0}, {4, 0, 0}, {3, 1, 0});
  add_triangle(mesh, {8, 0, 0}, {10, 0, 0}, {8, 1, 0});
  constexpr double padding = 1e-4;  // The boxes are widened by 2^-21 of their coordinates.
  CHECK(cost(mesh, {.max_leaf_size = 1}) == Approx(1 + 0.1 + 0.1 + 0.2).epsilon(padding));
  CHECK(cost(mesh, {.max_leaf_size = 1, .traversal_cost = 2, .intersection_cost = 5}) ==
        Approx(2 + 5 * 0.4).epsilon(padding));
}

TEST_CASE("a BVH has two or eight children a node") {
  const auto geometry = share({soup(5, 1, 1)});
  for (const int width : {0, 1, 4, 16})
    CHECK_THROWS_AS(build_accelerator(Backend::bvh, geometry, {.bvh_width = width}), Error);
}
