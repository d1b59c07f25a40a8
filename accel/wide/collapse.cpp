// SPDX-License-Identifier: Apache-2.0
#include "accel/wide/collapse.h"

#include <algorithm>

#include "core/parallel.h"

namespace twinray {
namespace {

/// Subtrees below this depth are not worth a task.
constexpr int task_depth = 6;

}  // namespace

CollapsePlan::CollapsePlan(const BuildTree& tree, int max_leaf_size)
    : tree_(tree),
      max_leaf_size_(std::uint32_t(max_leaf_size)),
      root_area_(tree.nodes[0].box.half_area()),
      entries_(tree.nodes.size()) {
  fill(0, 0);
}

bool CollapsePlan::is_leaf(std::uint32_t node) const {
  return entries_[node].primitives <= max_leaf_size_ &&
         leaf_cost * probability(node) <= entries_[node].cost[0];
}

CollapsePlan::Children CollapsePlan::children(std::uint32_t node) const {
  Children children;
  divide(node, WideNode::width, children);
  return children;
}

void CollapsePlan::fill(std::uint32_t index, int depth) {
  const BuildTree::Node& node = tree_.nodes[index];
  if (node.count > 0) {
    entries_[index].primitives = node.count;
    std::fill_n(entries_[index].cost, max_trees, leaf_cost * probability(index));
    return;
  }
  const auto fill_first = [&] { fill(node.first, depth + 1); };
  const auto fill_second = [&] { fill(node.first + 1, depth + 1); };
  if (depth < task_depth) {
    parallel_invoke(fill_first, fill_second);
  } else {
    fill_first();
    fill_second();
  }
  fill_inner(index);
}

void CollapsePlan::fill_inner(std::uint32_t index) {
  const BuildTree::Node& node = tree_.nodes[index];
  const float own = probability(index);
  Entry& entry = entries_[index];
  entry.primitives = entries_[node.first].primitives + entries_[node.first + 1].primitives;
  entry.cost[0] = node_cost * own + distributed(node, WideNode::width);
  if (entry.primitives <= max_leaf_size_) entry.cost[0] = std::min(entry.cost[0], leaf_cost * own);
  for (int trees = 2; trees <= max_trees; ++trees)
    entry.cost[trees - 1] = std::min(entry.cost[trees - 2], distributed(node, trees));
}

/// The least cost of both children as a forest of `trees`, two at least.
float CollapsePlan::distributed(const BuildTree::Node& node, int trees) const {
  const float *const first = entries_[node.first].cost, *const second = entries_[node.first + 1].cost;
  float least = first[0] + second[trees - 2];
  for (int i = 2; i < trees; ++i) least = std::min(least, first[i - 1] + second[trees - i - 1]);
  return least;
}

/// How many of the trees are then the first child's.
int CollapsePlan::first_trees(const BuildTree::Node& node, int trees) const {
  const float *const first = entries_[node.first].cost, *const second = entries_[node.first + 1].cost;
  const float least = distributed(node, trees);
  int i = 1;
  while (first[i - 1] + second[trees - i - 1] != least) ++i;
  return i;
}

void CollapsePlan::divide(std::uint32_t index, int trees, Children& children) const {
  const BuildTree::Node& node = tree_.nodes[index];
  const int first = first_trees(node, trees);
  gather(node.first, first, children);
  gather(node.first + 1, trees - first, children);
}

void CollapsePlan::gather(std::uint32_t node, int trees, Children& children) const {
  const float* const cost = entries_[node].cost;
  while (trees > 1 && cost[trees - 1] == cost[trees - 2]) --trees;
  if (trees == 1)
    children.nodes[children.count++] = node;
  else
    divide(node, trees, children);
}

}  // namespace twinray
