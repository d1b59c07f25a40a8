// SPDX-License-Identifier: Apache-2.0
#include "accel/build/reinsertion.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "accel/bvh/build.h"
#include "accel/bvh/invariants.h"
#include "core/parallel.h"
#include "tests/support/catch.h"
#include "tests/support/shapes.h"

using namespace twinray;
using namespace twinray::test;

namespace {

BuildTree tree_of(const Geometry& geometry, const BuildOptions& options) {
  return build_tree(collect_primitives(geometry, geometry.direct_shapes()), options);
}

/// The sum of the areas of all inner nodes.
double inner_area(const BuildTree& tree, std::uint32_t index = 0) {
  const BuildTree::Node& node = tree.nodes[index];
  if (node.count > 0) return 0;
  return node.box.half_area() + inner_area(tree, node.first) + inner_area(tree, node.first + 1);
}

using Leaf = std::pair<std::uint32_t, std::uint32_t>;

/// The ranges of primitives of all leaves.
void collect_leaves(const BuildTree& tree, std::uint32_t index, std::multiset<Leaf>& leaves) {
  const BuildTree::Node& node = tree.nodes[index];
  if (node.count > 0) {
    leaves.insert({node.first, node.count});
    return;
  }
  collect_leaves(tree, node.first, leaves);
  collect_leaves(tree, node.first + 1, leaves);
}

std::multiset<Leaf> leaves_of(const BuildTree& tree) {
  std::multiset<Leaf> leaves;
  if (!tree.nodes.empty()) collect_leaves(tree, 0, leaves);
  return leaves;
}

bool same_subtrees(const BuildTree& a, const BuildTree& b, std::uint32_t index = 0) {
  const BuildTree::Node &x = a.nodes[index], &y = b.nodes[index];
  if (!(x.box == y.box) || x.first != y.first || x.count != y.count) return false;
  return x.count > 0 || (same_subtrees(a, b, x.first) && same_subtrees(a, b, x.first + 1));
}

BuildTree reinserted(BuildTree tree, const ReinsertionEffort& effort, int threads) {
  with_threads(threads, [&] { reinsert(tree, effort); });
  return tree;
}

constexpr ReinsertionEffort efforts[] = {{1, 0.1}, {1, 1}, {4, 1}};

}  // namespace

TEST_CASE("a leaf in the wrong half is moved to its neighbours") {
  // Two groups of triangles far apart; the tree has one of each group in the other's half.
  Mesh mesh;
  for (const float x : {0.0f, 1.0f, 101.0f, 100.0f, 2.0f, 102.0f})
    add_triangle(mesh, {x, 0, 0}, {x + 1, 0, 0}, {x, 1, 1});
  const auto geometry = share({mesh});
  BuildTree tree;
  tree.primitives = collect_primitives(*geometry, geometry->direct_shapes());
  tree.nodes.assign(11, {});
  const auto set = [&](std::uint32_t index, std::uint32_t first, std::uint32_t count) {
    tree.nodes[index].first = first;
    tree.nodes[index].count = count;
  };
  set(0, 5, 0);                // 0 to 2, and 3 to 5
  set(5, 3, 0), set(6, 9, 0);  // 0 and 1, 2; 3 and 4, 5
  set(3, 1, 0), set(9, 7, 0);  // 0, 1; 3, 4
  for (const auto& [node, primitive] :
       {std::pair{1u, 0u}, {2u, 1u}, {4u, 2u}, {7u, 3u}, {8u, 4u}, {10u, 5u}}) {
    set(node, primitive, 1);
    tree.nodes[node].box = tree.primitives[primitive].box;
  }
  for (const std::uint32_t index : {3u, 9u, 5u, 6u, 0u})
    for (const std::uint32_t child : {tree.nodes[index].first, tree.nodes[index].first + 1})
      tree.nodes[index].box.extend(tree.nodes[child].box);
  const Aabb whole = tree.nodes[0].box;
  reinsert(tree, {2, 1});
  CHECK(find_fault(lay_out(tree, *geometry), *geometry, 1) == "");
  CHECK(tree.nodes[0].box == whole);
  for (const std::uint32_t child : {tree.nodes[0].first, tree.nodes[0].first + 1})
    CHECK(tree.nodes[child].box.extent().x == 3);
}

TEST_CASE("reinsertion lowers the cost of every builder's tree and keeps its leaves") {
  Mesh walls = soup(20000, 0.02f, 7);
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 corners[3] = {{-1, -1, -1}, {1, -1, -1}, {-1, 1, 1}};
    for (Vec3& p : corners) std::swap(p.x, p[axis]);
    add_triangle(walls, corners[0], corners[1], corners[2]);
  }
  const auto geometry = share({walls, random_spheres(60, 0.2f, 2)});
  for (const BvhSplit split : {BvhSplit::sah, BvhSplit::median, BvhSplit::midpoint, BvhSplit::mean}) {
    const BuildTree tree = tree_of(*geometry, {.bvh_split = split});
    double cost = inner_area(tree);
    for (const ReinsertionEffort& effort : efforts) {
      CAPTURE(int(split), effort.rounds, effort.share);
      const BuildTree better = reinserted(tree, effort, 2);
      CHECK(inner_area(better) < cost);
      cost = inner_area(better);
      CHECK(leaves_of(better) == leaves_of(tree));
      CHECK(find_fault(lay_out(better, *geometry), *geometry, 4) == "");
    }
  }
}

TEST_CASE("reinsertion gives the same tree on any number of threads") {
  const auto geometry = share({soup(20000, 0.05f, 3)});
  const BuildTree tree = tree_of(*geometry, {.bvh_split = BvhSplit::median});
  for (const ReinsertionEffort& effort : efforts) {
    const BuildTree one = reinserted(tree, effort, 1);
    CHECK(same_subtrees(one, reinserted(tree, effort, 2)));
    CHECK(same_subtrees(one, reinserted(tree, effort, 7)));
  }
}

TEST_CASE("reinsertion of a degenerate geometry's tree leaves it without a fault") {
  for (const auto& geometry : degenerate_geometries())
    for (const int leaf : {1, 4}) {
      CAPTURE(geometry->primitive_count(), leaf);
      const BuildTree tree = reinserted(tree_of(*geometry, {.max_leaf_size = leaf}), {3, 1}, 1);
      CHECK(find_fault(lay_out(tree, *geometry), *geometry, leaf) == "");
    }
}

TEST_CASE("reinsertion makes no tree deeper than the stack") {
  // Triangles whose distance from the origin doubles from one to the next: the cheapest tree is a chain. In
  // the middle of it lie many of one size, whose subtree is deep itself.
  Mesh mesh;
  for (int i = -120; i < 39; ++i) {
    const float x = std::ldexp(1.0f, i);
    add_triangle(mesh, {x, 0, 0}, {x, x, 0}, {x, 0, x});
    add_triangle(mesh, {-x, 0, 0}, {-x, x, 0}, {-x, 0, x});
  }
  const auto geometry = share({mesh});
  for (const BvhSplit split : {BvhSplit::median, BvhSplit::midpoint}) {
    const BuildTree tree = tree_of(*geometry, {.bvh_split = split, .max_leaf_size = 1});
    const BuildTree better = reinserted(tree, {20, 1}, 1);
    CHECK(inner_area(better) < inner_area(tree));
    CHECK(find_fault(lay_out(better, *geometry), *geometry, 1) == "");
  }
}
