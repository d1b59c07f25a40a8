// SPDX-License-Identifier: Apache-2.0
// rtcBuildBVH decides which primitives lie together; the boxes are made anew, bottom up, from our own.
//
// With quality HIGH it also splits primitives at planes, and lays the pieces into leaves of their own. A
// piece here is a part of the primitive's padded box, not of the primitive: both parts of a box share the
// plane, and everything else. Then no ray loses a hit (accel/canonical/slab.h has near and far). Let t be a
// hit's parameter, so t >= 0 and near <= t <= far for the padded box; the same holds for one of its two
// parts:
//
//   Only the plane's axis matters. Take a direction that is not negative along it (else mirror all). The
//   first part ends where the plane's far term is F = (plane - far_origin) far_inverse, the second begins
//   where its near term is N = (plane - near_origin) near_inverse, both rounded. If t <= F it is in the first
//   part. Else t > F, and t >= N: far_origin <= near_origin and 0 < near_inverse <= far_inverse, and rounding
//   is monotone; so either plane - near_origin > 0, and N <= F < t, or N <= 0 <= t.
//
// By induction t lies in one of all pieces, and no node above that piece is culled before the hit is found.
// Its leaf tests the whole primitive by its own box, so how it was split changes no answer. Clipping the
// primitive itself would give smaller boxes, of which nothing of the kind is known.
#include "accel/embree/builder.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <memory>
#include <new>
#include <type_traits>

#include "accel/canonical/slab.h"
#include "accel/embree/device.h"
#include "core/error.h"
#include "core/parallel.h"

namespace twinray {
namespace {

/// What our traversal allows is less, but subtrees that lie too deep for it are divided anew; so this bounds
/// nothing but the recursion of Embree, which ends in an error below.
constexpr unsigned deepest = 256;

struct ReleaseBvh {
  void operator()(RTCBVH bvh) const { rtcReleaseBVH(bvh); }
};
using BvhOwner = std::unique_ptr<std::remove_pointer_t<RTCBVH>, ReleaseBvh>;

/// A node in the memory of its RTCBVH.
struct EmbreeNode {
  EmbreeNode* children[2] = {};         ///< Inner nodes only.
  RTCBuildPrimitive* pieces = nullptr;  ///< Leaves only: primitives, or pieces of them.
  std::size_t count = 0;                ///< Of them below; of inner nodes, once counted.
};

/// `count` objects aligned as their type asks (RTCBuildPrimitive: to 32 bytes).
template <typename T>
T* allocate(RTCThreadLocalAllocator allocator, std::size_t count) {
  static_assert(alignof(T) <= 64, "Embree's blocks of memory begin at multiples of 64 bytes");
  void* const memory = rtcThreadLocalAlloc(allocator, count * sizeof(T), alignof(T));
  assert(reinterpret_cast<std::uintptr_t>(memory) % alignof(T) == 0);
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

Aabb box_of(const RTCBuildPrimitive& piece) {
  return {{piece.lower_x, piece.lower_y, piece.lower_z}, {piece.upper_x, piece.upper_y, piece.upper_z}};
}

RTCBuildPrimitive make_piece(const Aabb& box, unsigned index) {
  return {box.lower.x, box.lower.y, box.lower.z, 0, box.upper.x, box.upper.y, box.upper.z, index};
}

RTCBounds bounds_of(const Aabb& box) {
  return {box.lower.x, box.lower.y, box.lower.z, 0, box.upper.x, box.upper.y, box.upper.z, 0};
}

/// Pieces of the same primitive become one.
void* create_leaf(RTCThreadLocalAllocator allocator, const RTCBuildPrimitive* primitives, std::size_t count,
                  void*) {
  EmbreeNode* const node = allocate<EmbreeNode>(allocator, 1);
  node->pieces = allocate<RTCBuildPrimitive>(allocator, count);
  for (std::size_t i = 0; i < count; ++i) {
    RTCBuildPrimitive* const end = node->pieces + node->count;
    RTCBuildPrimitive* const same = std::find_if(node->pieces, end, [&](const RTCBuildPrimitive& piece) {
      return piece.primID == primitives[i].primID;
    });
    Aabb box = box_of(primitives[i]);
    if (same == end)
      ++node->count;
    else
      box.extend(box_of(*same));
    *same = make_piece(box, primitives[i].primID);
  }
  return node;
}

/// Divides a box at a plane; one that misses it goes through the nearest face.
void split(const RTCBuildPrimitive* piece, unsigned axis, float position, RTCBounds* first, RTCBounds* second,
           void*) {
  Aabb lower = box_of(*piece), upper = lower;
  const float plane = std::clamp(position, lower.lower[int(axis)], lower.upper[int(axis)]);
  lower.upper[int(axis)] = upper.lower[int(axis)] = plane;
  *first = bounds_of(lower);
  *second = bounds_of(upper);
}

bool splits_primitives(const BuildOptions& options) { return options.bvh_builder == BvhBuilder::embree_high; }

/// With room behind them for as many again where they may be split.
std::vector<RTCBuildPrimitive> embree_primitives(const BuildPrimitives& primitives, bool may_split) {
  std::vector<RTCBuildPrimitive> result(primitives.size() * (may_split ? 2 : 1));
  for (std::size_t i = 0; i < primitives.size(); ++i)
    result[i] = make_piece(may_split ? padded(primitives[i].box) : primitives[i].box, unsigned(i));
  return result;
}

RTCBuildArguments arguments_of(const BuildOptions& options, std::vector<RTCBuildPrimitive>& primitives,
                               std::size_t count) {
  RTCBuildArguments arguments = rtcDefaultBuildArguments();
  const bool is_low = options.bvh_builder == BvhBuilder::embree_low;
  arguments.buildQuality = is_low                       ? RTC_BUILD_QUALITY_LOW
                           : splits_primitives(options) ? RTC_BUILD_QUALITY_HIGH
                                                        : RTC_BUILD_QUALITY_MEDIUM;
  arguments.maxDepth = deepest;
  arguments.maxLeafSize = unsigned(options.max_leaf_size);
  arguments.minLeafSize = is_low ? arguments.maxLeafSize : 1;  // Morton codes alone never make a leaf.
  arguments.traversalCost = float(options.traversal_cost);
  arguments.intersectionCost = float(options.intersection_cost);
  arguments.primitives = primitives.data();
  arguments.primitiveCount = count;
  arguments.primitiveArrayCapacity = primitives.size();
  arguments.createNode = create_node;
  arguments.setNodeChildren = set_children;
  arguments.setNodeBounds = set_bounds;
  arguments.createLeaf = create_leaf;
  arguments.splitPrimitive = splits_primitives(options) ? split : nullptr;
  return arguments;
}

/// Counts the pieces below a node, and marks the primitives that they belong to.
std::size_t count_pieces(EmbreeNode& node, std::vector<bool>& is_held) {
  if (!node.pieces)
    return node.count = count_pieces(*node.children[0], is_held) + count_pieces(*node.children[1], is_held);
  for (std::size_t i = 0; i < node.count; ++i) is_held[node.pieces[i].primID] = true;
  return node.count;
}

/// Embree's nodes as a BuildTree.
class Conversion {
 public:
  Conversion(const BuildPrimitives& primitives, const BuildOptions& options)
      : primitives_(primitives), options_(options) {}

  BuildTree convert(const EmbreeNode& root) {
    tree_.primitives.resize(root.count);
    tree_.nodes.resize(1);
    place(root, 0, 0, 0);
    return std::move(tree_);
  }

 private:
  /// Makes node `index` over the pieces from `first` on.
  void place(const EmbreeNode& node, std::uint32_t index, std::size_t first, int depth) {
    if (depth == free_bvh_depth || node.pieces) collect(node, first);
    if (depth == free_bvh_depth) return halve_subtree(tree_, options_, index, first, node.count);
    Aabb box;
    if (node.pieces) {
      for (std::size_t i = 0; i < node.count; ++i) box.extend(tree_.primitives[first + i].box);
      tree_.nodes[index] = {box, std::uint32_t(first), std::uint32_t(node.count)};
      return;
    }
    const auto pair = std::uint32_t(tree_.nodes.size());
    tree_.nodes.resize(pair + 2);
    const std::size_t left = node.children[0]->count;
    place(*node.children[0], pair, first, depth + 1);
    place(*node.children[1], pair + 1, first + left, depth + 1);
    for (const std::uint32_t child : {pair, pair + 1}) box.extend(tree_.nodes[child].box);
    tree_.nodes[index] = {box, pair, 0};
  }

  /// Copies all pieces below a node to `first` and behind.
  void collect(const EmbreeNode& node, std::size_t first) {
    if (node.pieces) {
      for (std::size_t i = 0; i < node.count; ++i)
        tree_.primitives[first + i] = {box_of(node.pieces[i]), primitives_[node.pieces[i].primID].id};
      return;
    }
    collect(*node.children[0], first);
    collect(*node.children[1], first + node.children[0]->count);
  }

  const BuildPrimitives& primitives_;
  const BuildOptions& options_;
  BuildTree tree_;
};

}  // namespace

BuildTree build_tree_by_embree(BuildPrimitives primitives, const BuildOptions& options) {
  if (options.max_leaf_size > RTC_BUILD_MAX_PRIMITIVES_PER_LEAF)
    throw Error("Embree's builders make leaves of up to 32 primitives");
  if (primitives.empty()) return {};
  embree::Device device("");
  const BvhOwner bvh(rtcNewBVH(device.get()));
  std::vector<RTCBuildPrimitive> input = embree_primitives(primitives, splits_primitives(options));
  RTCBuildArguments arguments = arguments_of(options, input, primitives.size());
  arguments.bvh = bvh.get();
  EmbreeNode* root = nullptr;
  with_threads(1, [&] { root = static_cast<EmbreeNode*>(rtcBuildBVH(&arguments)); });
  device.check("to build our tree");
  std::vector<bool> is_held(primitives.size());
  const std::size_t pieces = root ? count_pieces(*root, is_held) : 0;
  const bool has_all = std::find(is_held.begin(), is_held.end(), false) == is_held.end();
  if (!has_all || (!splits_primitives(options) && pieces != primitives.size()))
    throw Error("Embree failed to build our tree: it does not hold each primitive once");
  return Conversion(primitives, options).convert(*root);
}

}  // namespace twinray
