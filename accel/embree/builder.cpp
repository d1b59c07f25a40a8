// SPDX-License-Identifier: Apache-2.0
// rtcBuildBVH decides which primitives lie together; the boxes are made anew, bottom up, from our own.
//
// Quality HIGH is left out. With spatial splits a primitive lies in several leaves, whose boxes hold a piece
// of it each; but the canonical hit is safe only in boxes that hold the whole of a primitive (core/slab.h),
// and in such boxes the split is of no use. Without spatial splits Embree takes HIGH for MEDIUM.
#include "accel/embree/builder.h"

#include <algorithm>
#include <memory>
#include <new>
#include <type_traits>

#include "accel/embree/device.h"
#include "core/error.h"
#include "core/parallel.h"

namespace twinray {
namespace {

/// What our traversal allows is less, but subtrees that lie too deep for it are divided anew; so this bounds
/// nothing but the recursion of Embree, which ends in an error below.
constexpr unsigned deepest = 256;

constexpr std::size_t alignment = 16;

struct ReleaseBvh {
  void operator()(RTCBVH bvh) const { rtcReleaseBVH(bvh); }
};
using BvhOwner = std::unique_ptr<std::remove_pointer_t<RTCBVH>, ReleaseBvh>;

/// A node in the memory of its RTCBVH.
struct EmbreeNode {
  EmbreeNode* children[2] = {};      ///< Inner nodes only.
  std::uint32_t* indices = nullptr;  ///< Leaves only: which primitives.
  std::size_t count = 0;             ///< Primitives below; of inner nodes, once counted.
};

template <typename T>
T* allocate(RTCThreadLocalAllocator allocator, std::size_t count) {
  void* const memory = rtcThreadLocalAlloc(allocator, count * sizeof(T), alignment);
  return new (memory) T[count];
}

void* create_node(RTCThreadLocalAllocator allocator, unsigned, void*) {
  return allocate<EmbreeNode>(allocator, 1);
}

void set_children(void* pointer, void** children, unsigned, void*) {
  auto& node = *static_cast<EmbreeNode*>(pointer);
  for (int child = 0; child < 2; ++child) node.children[child] = static_cast<EmbreeNode*>(children[child]);
}

void set_bounds(void*, const RTCBounds**, unsigned, void*) {}

void* create_leaf(RTCThreadLocalAllocator allocator, const RTCBuildPrimitive* primitives, std::size_t count,
                  void*) {
  EmbreeNode* const node = allocate<EmbreeNode>(allocator, 1);
  node->indices = allocate<std::uint32_t>(allocator, count);
  node->count = count;
  for (std::size_t i = 0; i < count; ++i) node->indices[i] = primitives[i].primID;
  return node;
}

std::vector<RTCBuildPrimitive> embree_primitives(const std::vector<BuildPrimitive>& primitives) {
  std::vector<RTCBuildPrimitive> result(primitives.size());
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    const Aabb& box = primitives[i].box;
    result[i] = {box.lower.x, box.lower.y, box.lower.z, 0,
                 box.upper.x, box.upper.y, box.upper.z, unsigned(i)};
  }
  return result;
}

RTCBuildArguments arguments_of(const BuildOptions& options, std::vector<RTCBuildPrimitive>& primitives) {
  RTCBuildArguments arguments = rtcDefaultBuildArguments();
  const bool is_low = options.bvh_builder == BvhBuilder::embree_low;
  arguments.buildQuality = is_low ? RTC_BUILD_QUALITY_LOW : RTC_BUILD_QUALITY_MEDIUM;
  arguments.maxDepth = deepest;
  arguments.maxLeafSize = unsigned(options.max_leaf_size);
  arguments.minLeafSize = is_low ? arguments.maxLeafSize : 1;  // Morton codes alone never make a leaf.
  arguments.traversalCost = float(options.traversal_cost);
  arguments.intersectionCost = float(options.intersection_cost);
  arguments.primitives = primitives.data();
  arguments.primitiveCount = primitives.size();
  arguments.primitiveArrayCapacity = primitives.size();
  arguments.createNode = create_node;
  arguments.setNodeChildren = set_children;
  arguments.setNodeBounds = set_bounds;
  arguments.createLeaf = create_leaf;
  return arguments;
}

std::size_t count_primitives(EmbreeNode& node) {
  if (!node.indices) node.count = count_primitives(*node.children[0]) + count_primitives(*node.children[1]);
  return node.count;
}

/// Embree's nodes as a BuildTree.
class Conversion {
 public:
  Conversion(const std::vector<BuildPrimitive>& primitives, const BuildOptions& options)
      : primitives_(primitives), options_(options) {
    tree_.primitives.resize(primitives.size());
    tree_.nodes.resize(2 * primitives.size() - 1);
  }

  BuildTree convert(const EmbreeNode& root) {
    place(root, 0, 0, 0);
    return std::move(tree_);
  }

 private:
  /// Makes node `index` over the primitives from `first` on.
  void place(const EmbreeNode& node, std::uint32_t index, std::size_t first, int depth) {
    BuildTree::Node& made = tree_.nodes[index];
    if (depth == free_bvh_depth || node.indices) collect(node, first);
    if (depth == free_bvh_depth) return halve_subtree(tree_, options_, index, first, node.count);
    if (node.indices) {
      for (std::size_t i = 0; i < node.count; ++i) made.box.extend(tree_.primitives[first + i].box);
      made.first = std::uint32_t(first);
      made.count = std::uint32_t(node.count);
      return;
    }
    const std::size_t left = node.children[0]->count;
    made.first = std::uint32_t(2 * (first + left) - 1);
    place(*node.children[0], made.first, first, depth + 1);
    place(*node.children[1], made.first + 1, first + left, depth + 1);
    for (std::uint32_t child = 0; child < 2; ++child) made.box.extend(tree_.nodes[made.first + child].box);
  }

  /// Copies all primitives below a node to `first` and behind.
  void collect(const EmbreeNode& node, std::size_t first) {
    if (node.indices) {
      for (std::size_t i = 0; i < node.count; ++i) tree_.primitives[first + i] = primitives_[node.indices[i]];
      return;
    }
    collect(*node.children[0], first);
    collect(*node.children[1], first + node.children[0]->count);
  }

  const std::vector<BuildPrimitive>& primitives_;
  const BuildOptions& options_;
  BuildTree tree_;
};

}  // namespace

BuildTree build_tree_by_embree(std::vector<BuildPrimitive> primitives, const BuildOptions& options) {
  if (options.max_leaf_size > RTC_BUILD_MAX_PRIMITIVES_PER_LEAF)
    throw Error("Embree's builders make leaves of up to 32 primitives");
  if (primitives.empty()) return {};
  embree::Device device("");
  const BvhOwner bvh(rtcNewBVH(device.get()));
  std::vector<RTCBuildPrimitive> input = embree_primitives(primitives);
  RTCBuildArguments arguments = arguments_of(options, input);
  arguments.bvh = bvh.get();
  EmbreeNode* root = nullptr;
  with_threads(1, [&] { root = static_cast<EmbreeNode*>(rtcBuildBVH(&arguments)); });
  device.check("to build our tree");
  if (!root || count_primitives(*root) != primitives.size())
    throw Error("Embree failed to build our tree: it does not hold each primitive once");
  return Conversion(primitives, options).convert(*root);
}

}  // namespace twinray
