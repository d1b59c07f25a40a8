// SPDX-License-Identifier: Apache-2.0
#include "accel/build/binary_tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "core/error.h"
#include "core/parallel.h"

namespace twinray {
namespace {

constexpr std::size_t max_primitives = std::size_t{1} << 30;
/// Smaller subtrees are made by one task each.
constexpr std::size_t task_size = 4096;

/// A subtree while its tree grows: a part of its own for each task, so that no task waits for another.
struct Part {
  BuildTree::Node root;               ///< Inner: `first` is not known before all parts have their places.
  BuildTree::Nodes below;             ///< Of a small subtree all other nodes; `first` counts from here.
  std::unique_ptr<Part> children[2];  ///< Of a large one.
};

class TreeBuilder {
 public:
  TreeBuilder(BuildPrimitives& primitives, const BuildOptions& options)
      : primitives_(primitives), options_(options) {}

  /// Makes a node over the primitives [first, first + count), and appends all below it to `nodes`.
  BuildTree::Node build(std::size_t first, std::size_t count, int depth, BuildTree::Nodes& nodes) {
    const NodeRange range(std::span<BuildPrimitive>(primitives_).subspan(first, count));
    const std::size_t left = divide_at(range, depth);
    if (left == 0) return {range.box, std::uint32_t(first), std::uint32_t(count)};
    const std::size_t pair = nodes.size();
    nodes.resize(pair + 2);
    const BuildTree::Node one = build(first, left, depth + 1, nodes);
    const BuildTree::Node other = build(first + left, count - left, depth + 1, nodes);
    nodes[pair] = one;
    nodes[pair + 1] = other;
    return {range.box, std::uint32_t(pair), 0};
  }

  /// The same in parts.
  std::unique_ptr<Part> build_parts(std::size_t first, std::size_t count, int depth) {
    auto part = std::make_unique<Part>();
    if (count < task_size) {
      part->root = build(first, count, depth, part->below);
      return part;
    }
    const NodeRange range(std::span<BuildPrimitive>(primitives_).subspan(first, count));
    const std::size_t left = divide_at(range, depth);
    part->root = {range.box, std::uint32_t(first), left == 0 ? std::uint32_t(count) : 0};
    if (left == 0) return part;
    parallel_invoke([&] { part->children[0] = build_parts(first, left, depth + 1); },
                    [&] { part->children[1] = build_parts(first + left, count - left, depth + 1); });
    return part;
  }

 private:
  std::size_t divide_at(const NodeRange& range, int depth) const {
    if (range.primitives.size() == 1) return 0;
    if (depth < free_bvh_depth) return divide(range, options_);
    return range.primitives.size() <= std::size_t(options_.max_leaf_size) ? 0 : divide_by_median(range);
  }

  BuildPrimitives& primitives_;
  const BuildOptions& options_;
};

/// Puts the nodes of all parts into one array, depth first.
class Assembly {
 public:
  explicit Assembly(BuildTree::Nodes& nodes) : nodes_(nodes) {}

  void run(const Part& root) {
    place(root, 0);
    nodes_.resize(size_);
    parallel_for(places_.size(), 1, 0, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) copy(places_[i]);
    });
  }

 private:
  struct Place {
    const Part* part;
    std::size_t root, below;
  };

  void place(const Part& part, std::size_t root) {
    places_.push_back({&part, root, size_});
    if (!part.children[0]) {
      size_ += part.below.size();
      return;
    }
    const std::size_t pair = size_;
    size_ += 2;
    for (std::size_t child = 0; child < 2; ++child) place(*part.children[child], pair + child);
  }

  void copy(const Place& place) {
    const auto moved = [&](BuildTree::Node node) {
      if (node.count == 0) node.first += std::uint32_t(place.below);
      return node;
    };
    BuildTree::Node root = place.part->root;
    if (place.part->children[0]) root.first = 0;
    nodes_[place.root] = moved(root);
    std::transform(place.part->below.begin(), place.part->below.end(),
                   nodes_.begin() + std::ptrdiff_t(place.below), moved);
  }

  BuildTree::Nodes& nodes_;
  std::vector<Place> places_;
  std::size_t size_ = 1;
};

}  // namespace

namespace {

void check_count(std::size_t count, const char* what) {
  if (count > max_primitives)
    throw Error(fmt::format("the scene has {} {}; a BVH takes up to {}", count, what, max_primitives));
}

}  // namespace

BuildPrimitives collect_instances(const Geometry& geometry) {
  const std::size_t count = geometry.instances().size();
  check_count(count, "instances");
  BuildPrimitives primitives;
  primitives.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i)
    if (const Aabb& box = geometry.placed()[i].box; !box.is_empty()) primitives.push_back({box, {0, i}});
  return primitives;
}

BuildPrimitives collect_primitives(const Geometry& geometry, ShapeRange shapes) {
  check_count(geometry.primitive_count(), "primitives");
  BuildPrimitives primitives(geometry.primitive_count(shapes));
  std::size_t done = 0;
  for (std::uint32_t shape = shapes.first; shape < shapes.end(); ++shape) {
    const Mesh* mesh = geometry.mesh(shape);
    const std::size_t count = mesh ? mesh->triangles.size() : geometry.sphere_set(shape)->spheres.size();
    parallel_for(count, task_size, 0, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const PrimitiveId id{shape, std::uint32_t(i)};
        primitives[done + i] = {primitive_bounds(geometry, id), id};
      }
    });
    done += count;
  }
  return primitives;
}

BuildTree build_tree(BuildPrimitives primitives, const BuildOptions& options) {
  BuildTree tree;
  tree.primitives = std::move(primitives);
  if (tree.primitives.empty()) return tree;
  const auto parts = TreeBuilder(tree.primitives, options).build_parts(0, tree.primitives.size(), 0);
  Assembly(tree.nodes).run(*parts);
  return tree;
}

void halve_subtree(BuildTree& tree, const BuildOptions& options, std::uint32_t index, std::size_t first,
                   std::size_t count) {
  const BuildTree::Node node =
      TreeBuilder(tree.primitives, options).build(first, count, free_bvh_depth, tree.nodes);
  tree.nodes[index] = node;
}

}  // namespace twinray
