// SPDX-License-Identifier: Apache-2.0
// Reinsertion of subtrees.
//
// To move a node is to let its sibling take the place of their parent, and to make the parent's pair the
// children of a new node in the place of some target, which becomes the node's new sibling. A round looks for
// the best target of each of its nodes in a tree that stands still, in parallel, by branch and bound; then
// carries out one move after the other, the largest gain first. By then the tree has changed, so each move is
// judged again: its gain must still be one, and it must neither close a circle nor make the tree too deep.
#include "accel/build/reinsertion.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "accel/build/box_lanes.h"
#include "core/parallel.h"

namespace twinray {
namespace {

constexpr std::size_t searches_per_task = 512;

struct Move {
  float gain = 0;  ///< By how much the sum of areas falls; > 0 where there is a target.
  std::uint32_t node = 0, target = 0;
  std::uint32_t steps = 0;  ///< Of the search for it: the nodes that it looked at.
};

class Reinsertion {
 public:
  Reinsertion(BuildTree& tree, int most_depth)
      : nodes_(tree.nodes),
        most_depth_(most_depth),
        parents_(tree.nodes.size()),
        heights_(tree.nodes.size()) {
    link(0);
  }

  /// Returns the steps of its searches.
  std::uint64_t round(double share) {
    const std::vector<std::uint32_t> candidates = largest(share);
    std::vector<Move> moves(candidates.size());
    parallel_for(candidates.size(), searches_per_task, 0, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) moves[i] = best_move(candidates[i]);
    });
    std::uint64_t steps = 0;
    for (const Move& move : moves) steps += move.steps;
    std::erase_if(moves, [](const Move& move) { return !(move.gain > 0); });
    std::sort(moves.begin(), moves.end(), [](const Move& a, const Move& b) {
      return a.gain != b.gain ? a.gain > b.gain : a.node < b.node;
    });
    for (const Move& move : moves)
      if (is_sound(move) && gain(move) > 0) carry_out(move);
    return steps;
  }

 private:
  /// Fills in parents and heights, and lists all nodes but the root.
  int link(std::uint32_t index) {
    const BuildTree::Node& node = nodes_[index];
    if (node.count > 0) return 0;
    int height = 0;
    for (const std::uint32_t child : {node.first, node.first + 1}) {
      parents_[child] = index;
      places_.push_back(child);
      height = std::max(height, link(child));
    }
    return heights_[index] = std::uint8_t(height + 1);
  }

  BoxLanes box(std::uint32_t index) const { return BoxLanes::of(nodes_[index]); }
  float area(std::uint32_t index) const { return box(index).half_area(); }
  std::uint32_t sibling(std::uint32_t index) const {
    const std::uint32_t first = nodes_[parents_[index]].first;
    return index == first ? first + 1 : first;
  }

  std::vector<std::uint32_t> largest(double share) const {
    struct Sized {
      float area;
      std::uint32_t index;
    };
    std::vector<Sized> sized(places_.size());
    parallel_for(places_.size(), 1 << 14, 0, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) sized[i] = {area(places_[i]), places_[i]};
    });
    const std::size_t count = std::min(sized.size(), std::size_t(share * double(sized.size())) + 1);
    if (count < sized.size())
      std::nth_element(sized.begin(), sized.begin() + std::ptrdiff_t(count), sized.end(),
                       [](const Sized& a, const Sized& b) {
                         return a.area != b.area ? a.area > b.area : a.index < b.index;
                       });
    std::vector<std::uint32_t> indices(count);
    for (std::size_t i = 0; i < count; ++i) indices[i] = sized[i].index;
    return indices;
  }

  /// Climbs from a node to the root and looks at the subtrees beside the way.
  Move best_move(std::uint32_t node) const {
    Move best{.node = node};
    const BoxLanes moved = box(node);
    const std::uint32_t parent = parents_[node];
    float gain = area(parent);  // What leaving saves: the parent, and what the nodes above it shrink by.
    BoxLanes rest;
    for (std::uint32_t below = node; below != 0; below = parents_[below]) {
      if (below != node && below != parent) gain += area(below) - rest.half_area();
      const std::uint32_t beside = sibling(below);
      search(beside, gain, moved, best);
      rest.extend(box(beside));
    }
    return best;
  }

  /// Looks for a target in a subtree, whose gain is `gain` less the area of the new node there and less what
  /// the nodes above it, within this subtree, grow by.
  void search(std::uint32_t root, float gain, const BoxLanes& moved, Move& best) const {
    struct Waiting {
      std::uint32_t index;
      float gain;
    };
    Waiting stack[max_bvh_depth + 1];
    int size = 0;
    stack[size++] = {root, gain};
    const float moved_area = moved.half_area();
    while (size > 0) {
      const Waiting next = stack[--size];
      ++best.steps;
      const BoxLanes target = box(next.index);
      const float here = next.gain - target.joined(moved).half_area();
      if (here > best.gain) {
        best.gain = here;
        best.target = next.index;
      }
      const float below = here + target.half_area();
      const BuildTree::Node& node = nodes_[next.index];
      // A new node is no smaller than what is moved.
      if (node.count > 0 || below - moved_area <= best.gain) continue;
      stack[size++] = {node.first + 1, below};
      stack[size++] = {node.first, below};
    }
  }

  int depth(std::uint32_t index) const {
    int depth = 0;
    for (; index != 0; index = parents_[index]) ++depth;
    return depth;
  }

  /// Whether a move leaves a tree, and one that is not too deep.
  bool is_sound(const Move& move) const {
    if (move.target == 0 || move.target == move.node || move.target == sibling(move.node)) return false;
    for (std::uint32_t above = move.target; above != 0; above = parents_[above])
      if (above == move.node) return false;
    for (std::uint32_t above = move.node; above != 0; above = parents_[above])
      if (above == move.target) return false;
    const int height = std::max(heights_[move.node], heights_[move.target]);
    return depth(move.target) + 1 + height <= most_depth_;
  }

  /// By how much a sound move lowers the sum of areas of the tree as it is now.
  float gain(const Move& move) const {
    const BoxLanes moved = box(move.node);
    float gain = area(parents_[move.node]) - box(move.target).joined(moved).half_area();
    int node_depth = depth(move.node), target_depth = depth(move.target);
    std::uint32_t from = move.node, to = move.target;
    BoxLanes rest;
    while (parents_[from] != parents_[to]) {
      if (node_depth >= target_depth) {
        rest.extend(box(sibling(from)));
        from = parents_[from];
        --node_depth;
        if (from != parents_[move.node]) gain += area(from) - rest.half_area();
      } else {
        to = parents_[to];
        --target_depth;
        gain -= box(to).joined(moved).half_area() - area(to);
      }
    }
    return gain;
  }

  void adopt_children(std::uint32_t index) {
    const BuildTree::Node& node = nodes_[index];
    if (node.count == 0) parents_[node.first] = parents_[node.first + 1] = index;
  }
  void copy_node(std::uint32_t from, std::uint32_t to) {
    nodes_[to] = nodes_[from];
    heights_[to] = heights_[from];
    adopt_children(to);
  }

  void carry_out(const Move& move) {
    const std::uint32_t left = parents_[move.node], beside = sibling(move.node);
    const std::uint32_t pair = std::min(move.node, beside);
    copy_node(beside, left);
    copy_node(move.target, beside);
    nodes_[move.target].first = pair;
    nodes_[move.target].count = 0;
    adopt_children(move.target);
    refit(move.target);
    if (left != 0) refit(parents_[left]);
  }

  /// Makes the boxes and heights of a node and of those above it anew, as far as they change.
  void refit(std::uint32_t index) {
    for (;; index = parents_[index]) {
      BuildTree::Node& node = nodes_[index];
      const Aabb joined = box(node.first).joined(box(node.first + 1)).aabb();
      const auto height = std::uint8_t(1 + std::max(heights_[node.first], heights_[node.first + 1]));
      if (joined == node.box && height == heights_[index]) return;
      node.box = joined;
      heights_[index] = height;
      if (index == 0) return;
    }
  }

  BuildTree::Nodes& nodes_;
  const int most_depth_;
  std::vector<std::uint32_t> parents_;
  std::vector<std::uint8_t> heights_;  ///< Edges to the deepest leaf below.
  std::vector<std::uint32_t> places_;  ///< The indices that stand for nodes, but the root's.
};

}  // namespace

std::uint64_t reinsert(BuildTree& tree, const ReinsertionEffort& effort) {
  if (tree.nodes.size() < 2 || effort.rounds == 0) return 0;
  Reinsertion reinsertion(tree, effort.most_depth);
  std::uint64_t steps = 0;
  for (int i = 0; i < effort.rounds; ++i) steps += reinsertion.round(effort.share);
  return steps;
}

}  // namespace twinray
