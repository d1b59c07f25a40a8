// SPDX-License-Identifier: Apache-2.0
#include "accel/build/split.h"

#include <algorithm>
#include <tuple>
#include <vector>

#include "accel/build/box_lanes.h"
#include "core/parallel.h"

namespace twinray {
namespace {

/// The boxes of primitives and of their centres.
struct Boxes {
  BoxLanes box, centers;

  void extend(const Boxes& other) {
    box.extend(other.box);
    centers.extend(other.centers);
  }
};

Boxes boxes_of(std::span<const BuildPrimitive> primitives) {
  Boxes boxes;
  for (const BuildPrimitive& primitive : primitives) {
    const BoxLanes box = BoxLanes::of(primitive);
    const Float4 center = box.center();
    boxes.extend({box, {center, center}});
  }
  return boxes;
}

/// The same bits as boxes_of: fixed parts, joined in their order.
Boxes boxes_in_parallel(std::span<const BuildPrimitive> primitives) {
  constexpr std::size_t size = 1 << 13;
  std::vector<Boxes> parts((primitives.size() + size - 1) / size);
  parallel_for(parts.size(), 1, 0, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      parts[i] = boxes_of(primitives.subspan(i * size, std::min(size, primitives.size() - i * size)));
  });
  Boxes boxes;
  for (const Boxes& other : parts) boxes.extend(other);
  return boxes;
}

}  // namespace

NodeRange::NodeRange(std::span<BuildPrimitive> range) : primitives(range) {
  const Boxes boxes = range.size() < parallel_range ? boxes_of(range) : boxes_in_parallel(range);
  box = boxes.box.aabb();
  centers = boxes.centers.aabb();
}

int NodeRange::longest_axis() const {
  const Vec3 extent = centers.extent();
  if (extent.x >= extent.y && extent.x >= extent.z) return 0;
  return extent.y >= extent.z ? 1 : 2;
}

std::size_t divide_by_median(const NodeRange& range) {
  const int axis = range.longest_axis();
  const auto key = [axis](const BuildPrimitive& primitive) {
    return std::tuple(primitive.center()[axis], primitive.id.mesh, primitive.id.primitive);
  };
  const std::size_t half = range.primitives.size() / 2;
  std::nth_element(range.primitives.begin(), range.primitives.begin() + std::ptrdiff_t(half),
                   range.primitives.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
  return half;
}

std::size_t divide_by_midpoint(const NodeRange& range) {
  const int axis = range.longest_axis();
  const float middle = range.centers.center()[axis];
  const std::size_t count = part(
      range.primitives, [&](const BuildPrimitive& primitive) { return primitive.center()[axis] < middle; });
  return count == 0 || count == range.primitives.size() ? divide_by_median(range) : count;
}

std::size_t divide_by_mean(const NodeRange& range) {
  const int axis = range.longest_axis();
  double sum = 0;
  for (const BuildPrimitive& primitive : range.primitives) sum += double(primitive.center()[axis]);
  const double mean = sum / double(range.primitives.size());
  const std::size_t count = part(range.primitives, [&](const BuildPrimitive& primitive) {
    return double(primitive.center()[axis]) < mean;
  });
  return std::clamp<std::size_t>(count, 1, range.primitives.size() - 1);
}

std::size_t divide(const NodeRange& range, const BuildOptions& options) {
  const std::size_t count = range.primitives.size();
  const bool may_be_leaf = count <= std::size_t(options.max_leaf_size);
  if (range.is_coincident()) return may_be_leaf ? 0 : count / 2;
  if (options.bvh_split == BvhSplit::sah) return divide_by_sah(range, options);
  if (may_be_leaf) return 0;
  switch (options.bvh_split) {
    case BvhSplit::midpoint:
      return divide_by_midpoint(range);
    case BvhSplit::mean:
      return divide_by_mean(range);
    default:
      return divide_by_median(range);
  }
}

}  // namespace twinray
