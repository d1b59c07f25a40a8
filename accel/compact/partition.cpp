// SPDX-License-Identifier: Apache-2.0
#include "accel/compact/partition.h"

#include <algorithm>

#include "accel/build/split.h"
#include "accel/wide/node.h"

namespace twinray {
namespace {

constexpr std::size_t parts_of_all = 16;
/// Levels that the split method decides. Below them the primitives are halved, which takes five levels at
/// most to come from all to a sixteenth.
constexpr int free_part_depth = max_part_depth - 5;

class Partitioner {
 public:
  Partitioner(BuildPrimitives& primitives, const BuildOptions& options, std::size_t least)
      : primitives_(primitives),
        options_(options),
        part_size_(std::max(least, (primitives.size() + parts_of_all - 1) / parts_of_all)) {}

  Partition run() {
    partition_.tree.nodes.resize(1);
    const BuildTree::Node root = divide_range(0, primitives_.size(), 0);
    partition_.tree.nodes[0] = root;
    return std::move(partition_);
  }

 private:
  BuildTree::Node divide_range(std::size_t first, std::size_t count, int depth) {
    const NodeRange range(std::span<BuildPrimitive>(primitives_).subspan(first, count));
    if (count <= part_size_) return add_part(range.box, {first, count});
    const std::size_t left = depth < free_part_depth ? divide(range, options_) : divide_by_median(range);
    BuildTree::Nodes& nodes = partition_.tree.nodes;
    const std::size_t pair = nodes.size();
    nodes.resize(pair + 2);
    const BuildTree::Node one = divide_range(first, left, depth + 1);
    const BuildTree::Node other = divide_range(first + left, count - left, depth + 1);
    nodes[pair] = one;
    nodes[pair + 1] = other;
    return {range.box, std::uint32_t(pair), 0};
  }

  BuildTree::Node add_part(const Aabb& box, const Partition::Part& part) {
    const auto number = std::uint32_t(partition_.parts.size());
    partition_.parts.push_back(part);
    partition_.tree.primitives.push_back({box, {0, number}});
    return {box, number, 1};
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
