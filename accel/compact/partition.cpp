// SPDX-License-Identifier: Apache-2.0
#include "accel/compact/partition.h"

#include <algorithm>
#include <functional>
#include <tuple>
#include <utility>

#include "accel/build/reinsertion.h"
#include "accel/build/split.h"
#include "accel/wide/node.h"

namespace twinray {
namespace {

constexpr std::size_t parts_of_all = 16;
/// Of all primitives' box, the area of a box that is large; and how many primitives have such at most.
constexpr float large_area = 1.0f / 64;
constexpr std::size_t most_large = 64;
/// Levels that the split method decides. Below them pieces that are too large are halved, which takes five
/// levels at most to come from all to a sixteenth, and others are left as they are.
constexpr int free_part_depth = max_part_depth - 5;

/// An order in which equal boxes follow each other.
bool is_before(const BuildPrimitive& a, const BuildPrimitive& b) {
  const auto key = [](const BuildPrimitive& p) {
    const auto& [lower, upper] = p.box;
    return std::tuple(lower.x, lower.y, lower.z, upper.x, upper.y, upper.z, p.id.mesh, p.id.primitive);
  };
  return key(a) < key(b);
}

bool is_one_box(std::span<const BuildPrimitive> primitives) {
  return std::all_of(primitives.begin(), primitives.end(),
                     [&](const BuildPrimitive& p) { return p.box == primitives[0].box; });
}

/// Of several primitives in that order the place nearest to their middle that parts no equal boxes; the
/// middle where all are equal.
std::size_t middle_of(std::span<const BuildPrimitive> primitives) {
  const std::size_t middle = primitives.size() / 2;
  const auto parts = [&](std::size_t place) { return primitives[place - 1].box != primitives[place].box; };
  for (std::size_t away = 0; away < middle; ++away)
    for (const std::size_t place : {middle - away, middle + away})
      if (place < primitives.size() && parts(place)) return place;
  return middle;
}

class Partitioner {
 public:
  Partitioner(BuildPrimitives& primitives, const BuildOptions& options, std::size_t least)
      : primitives_(primitives),
        options_(options),
        part_size_(std::max(least, (primitives.size() + parts_of_all - 1) / parts_of_all)) {}

  Partition run() {
    BuildTree::Nodes& nodes = partition_.tree.nodes;
    nodes.resize(1);
    const NodeRange all(primitives_);
    const std::size_t small = set_apart_large(all.box);
    if (small == primitives_.size()) {
      divide_wide({all, 0, 0, 0});
    } else {
      auto [one, other] = pair_of({all, 0, 0, 0}, small);
      divide_wide(one);
      divide_large(other);
    }
    reinsert(partition_.tree, {.rounds = 2, .share = 1, .most_depth = max_part_depth});
    return std::move(partition_);
  }

 private:
  /// A range of the primitives, from `first` on, and the node that stands for it.
  struct Piece {
    NodeRange range;
    std::size_t first, node;
    int depth;

    std::size_t count() const { return range.primitives.size(); }
  };

  /// Moves the large primitives behind the others, unless these are many or all; returns the number of the
  /// others. A wall that shared a part with a few leaves of a tree would make the part's box a room's.
  std::size_t set_apart_large(const Aabb& all) {
    const auto is_small = [limit = all.half_area() * large_area](const BuildPrimitive& primitive) {
      return primitive.box.half_area() < limit;
    };
    const auto large = std::count_if(primitives_.begin(), primitives_.end(), std::not_fn(is_small));
    const std::size_t most = std::min(most_large, primitives_.size() - 1);
    if (large == 0 || std::size_t(large) > most) return primitives_.size();
    const auto first = std::partition(primitives_.begin(), primitives_.end(), is_small);
    std::sort(first, primitives_.end(), is_before);
    return std::size_t(first - primitives_.begin());
  }

  /// Halves a piece of large primitives until those of each part have one box, as a rectangle's triangles.
  void divide_large(const Piece& piece) {
    const std::span<BuildPrimitive> primitives = piece.range.primitives;
    if (is_one_box(primitives) && primitives.size() <= std::size_t(options_.max_leaf_size))
      return add_part(piece);
    const auto [one, other] = pair_of(piece, middle_of(primitives));
    divide_large(one);
    divide_large(other);
  }

  /// Divides a piece into as many as a wide node has children, the largest box first, and these likewise. A
  /// level of half-empty nodes would be one more level for each ray.
  void divide_wide(const Piece& whole) {
    if (whole.count() <= part_size_) return add_part(whole);
    std::vector<Piece> pieces{whole};
    while (pieces.size() < std::size_t(WideNode::width)) {
      const auto widest = std::max_element(pieces.begin(), pieces.end(), [&](const Piece& a, const Piece& b) {
        return priority(a) < priority(b);
      });
      if (priority(*widest) < 0) break;
      auto [one, other] = divide_in_two(*widest);
      *widest = std::move(one);
      pieces.push_back(std::move(other));
    }
    std::sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) { return a.first < b.first; });
    for (const Piece& piece : pieces) divide_wide(piece);
  }

  /// The larger, the sooner a piece is divided; negative for one that is not.
  double priority(const Piece& piece) const {
    const int most_depth = piece.count() > part_size_ ? max_part_depth : free_part_depth;
    const bool is_leaf = piece.count() <= std::size_t(options_.max_leaf_size);
    return !is_leaf && piece.depth < most_depth ? piece.range.box.half_area() : -1;
  }

  std::pair<Piece, Piece> divide_in_two(const Piece& piece) {
    const bool is_free = piece.depth < free_part_depth;
    return pair_of(piece, is_free ? divide(piece.range, options_) : divide_by_median(piece.range));
  }

  /// The first `left` primitives of a piece, and the others, as the children of its node.
  std::pair<Piece, Piece> pair_of(const Piece& piece, std::size_t left) {
    const NodeRange& range = piece.range;
    BuildTree::Nodes& nodes = partition_.tree.nodes;
    const std::size_t pair = nodes.size();
    nodes.resize(pair + 2);
    nodes[piece.node] = {range.box, std::uint32_t(pair), 0};
    return {{NodeRange(range.primitives.first(left)), piece.first, pair, piece.depth + 1},
            {NodeRange(range.primitives.subspan(left)), piece.first + left, pair + 1, piece.depth + 1}};
  }

  void add_part(const Piece& piece) {
    const auto number = std::uint32_t(partition_.parts.size());
    partition_.parts.push_back({piece.first, piece.count()});
    partition_.tree.primitives.push_back({piece.range.box, {0, number}});
    partition_.tree.nodes[piece.node] = {piece.range.box, number, 1};
  }

  BuildPrimitives& primitives_;
  const BuildOptions& options_;
  const std::size_t part_size_;
  Partition partition_;
};

}  // namespace

Partition partition(BuildPrimitives& primitives, const BuildOptions& options, std::size_t least) {
  return Partitioner(primitives, options, least).run();
}

BuildPrimitives take_part(BuildPrimitives& primitives, const Partition::Part& part) {
  const auto first = primitives.begin() + std::ptrdiff_t(part.first);
  BuildPrimitives taken(first, first + std::ptrdiff_t(part.count));
  release_memory(&primitives[part.first], part.count);
  return taken;
}

}  // namespace twinray
