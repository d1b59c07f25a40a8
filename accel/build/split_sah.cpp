// SPDX-License-Identifier: Apache-2.0
// The search for the split of least cost, by two methods.
//
// Large ranges: on each axis the centres' box is cut into bins of equal width; each bin collects the count
// and the box of the primitives whose centres it holds; of very many primitives a sample will do. A sweep
// from the right gives the areas of all right sides, a sweep from the left pairs them with its own. Small
// ranges: the same sweeps over the primitives themselves, in the order of their centres.
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>

#include "accel/build/box_lanes.h"
#include "accel/build/cost_model.h"
#include "accel/build/split.h"

namespace twinray {
namespace {

constexpr std::size_t max_bins = 256;
/// Up to how many primitives every split is looked at.
constexpr std::size_t exact_size = 8;
/// About how many primitives of a larger range are binned.
constexpr std::size_t sample_size = 4096;
/// A centres' box that is no longer than this has no planes between its ends that could be told apart.
constexpr float least_extent = 1e-30f;

/// Between item - 1 and item (a bin or a primitive) of an axis.
struct Candidate {
  int axis = 0;
  std::size_t item = 0;
  float weighted_area = std::numeric_limits<float>::infinity();

  bool is_found() const { return weighted_area < std::numeric_limits<float>::infinity(); }
};

/// Bins for each unit of length.
float scale_of(const Aabb& centers, std::size_t bins, int axis) {
  const float extent = centers.upper[axis] - centers.lower[axis];
  return extent > least_extent ? float(bins) / extent : 0;
}

/// Which bin a centre falls into, on each axis. On an axis without extent it is always the first.
class Binning {
 public:
  Binning(const Aabb& centers, std::size_t bins) : last_(splat(float(bins - 1))) {
    for (int axis = 0; axis < 3; ++axis) {
      lower_[axis] = centers.lower[axis];
      scale_[axis] = scale_of(centers, bins, axis);
    }
  }
  Int4 bins(const BoxLanes& box) const {
    return __builtin_convertvector(min((box.center() - lower_) * scale_, last_), Int4);
  }

 private:
  Float4 lower_{}, scale_{}, last_;
};

/// Whether a centre falls into a bin before `item` of an axis: the same arithmetic for one axis.
class BeforeBin {
 public:
  BeforeBin(const Aabb& centers, std::size_t bins, const Candidate& candidate)
      : axis_(candidate.axis),
        lower_(centers.lower[axis_]),
        scale_(scale_of(centers, bins, axis_)),
        last_(float(bins - 1)),
        item_(float(candidate.item)) {}
  bool operator()(const BuildPrimitive& primitive) const {
    const float center = primitive.box.lower[axis_] * 0.5f + primitive.box.upper[axis_] * 0.5f;
    return std::min((center - lower_) * scale_, last_) < item_;
  }

 private:
  int axis_;
  float lower_, scale_, last_, item_;
};

/// Not initialised until clear().
struct Bins {
  struct Box {
    Float4 lower, upper;
  };
  std::array<std::array<Box, max_bins>, 3> boxes;
  std::array<std::array<std::uint32_t, max_bins>, 3> counts;

  BoxLanes box(std::size_t axis, std::size_t bin) const {
    return {boxes[axis][bin].lower, boxes[axis][bin].upper};
  }
  void extend(std::size_t axis, std::size_t bin, const BoxLanes& other) {
    Box& box = boxes[axis][bin];
    box = {min(box.lower, other.lower), max(box.upper, other.upper)};
  }

  void clear(std::size_t bins) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::fill_n(boxes[axis].begin(), bins, Box{splat(Aabb::infinity), splat(-Aabb::infinity)});
      std::fill_n(counts[axis].begin(), bins, 0u);
    }
  }
  void add(const Binning& binning, const BuildPrimitive& primitive) {
    const BoxLanes box = BoxLanes::of(primitive);
    const Int4 places = binning.bins(box);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto bin = std::size_t(places[axis]);
      extend(axis, bin, box);
      ++counts[axis][bin];
    }
  }
};

/// `count` boxes in a row, with `primitives(i)` primitives each; keeps the cheapest place to part them, both
/// sides of which hold primitives.
void sweep(int axis, std::size_t count, const CostModel& cost, auto box, auto primitives, Candidate& best) {
  std::array<float, max_bins> right;
  BoxLanes side;
  std::size_t held = 0;
  for (std::size_t i = count - 1; i > 0; --i) {
    side.extend(box(i));
    held += primitives(i);
    right[i] = held > 0 ? side.half_area() * float(cost.counted(held)) : Candidate().weighted_area;
  }
  side = BoxLanes();
  held = 0;
  for (std::size_t i = 1; i < count; ++i) {
    side.extend(box(i - 1));
    held += primitives(i - 1);
    if (held == 0) continue;
    const float sum = side.half_area() * float(cost.counted(held)) + right[i];
    if (sum < best.weighted_area) best = {axis, i, sum};
  }
}

bool is_leaf_cheaper(const NodeRange& range, const BuildOptions& options, const CostModel& cost,
                     const Candidate& best) {
  const std::size_t count = range.primitives.size();
  return count <= std::size_t(options.max_leaf_size) &&
         cost.leaf(count) <= cost.split(range.box.half_area(), double(best.weighted_area), count);
}

/// A small range needs few bins.
std::size_t bins_for(std::size_t primitives, int most) {
  return std::min(std::size_t(most), 4 + primitives / 4);
}

/// Of a large range as many primitives as tell where to part it; every so many, an odd number, so that they
/// are not all of one row where a mesh has rows.
void fill_with_sample(Bins& bins, const Binning& binning, std::span<const BuildPrimitive> primitives) {
  const std::size_t step = std::max<std::size_t>(1, primitives.size() / sample_size) | 1;
  for (std::size_t i = 0; i < primitives.size(); i += step) bins.add(binning, primitives[i]);
}

std::size_t divide_by_bins(const NodeRange& range, const BuildOptions& options, const CostModel& cost) {
  const std::size_t bin_count = bins_for(range.primitives.size(), options.bvh_bins);
  const Binning binning(range.centers, bin_count);
  Bins bins;
  bins.clear(bin_count);
  fill_with_sample(bins, binning, range.primitives);
  Candidate best;
  for (int axis = 0; axis < 3; ++axis)
    sweep(
        axis, bin_count, cost, [&](std::size_t i) { return bins.box(std::size_t(axis), i); },
        [&](std::size_t i) { return bins.counts[std::size_t(axis)][i]; }, best);
  if (is_leaf_cheaper(range, options, cost, best)) return 0;
  if (!best.is_found()) return divide_by_median(range);
  return part(range.primitives, BeforeBin(range.centers, bin_count, best));
}

/// Whether any way to part a range costs more than a leaf: each primitive is intersected at least as often as
/// its own box, and at least two blocks are intersected as often as the boxes of the largest and of the
/// smallest primitive.
bool is_surely_leaf(const NodeRange& range, const BuildOptions& options, const CostModel& cost) {
  if (range.primitives.size() > std::size_t(options.max_leaf_size)) return false;
  float sum = 0, largest = 0, smallest = std::numeric_limits<float>::infinity();
  for (const BuildPrimitive& primitive : range.primitives) {
    const float area = BoxLanes::of(primitive).half_area();
    sum += area;
    largest = std::max(largest, area);
    smallest = std::min(smallest, area);
  }
  const double least = std::max(double(sum), double(cost.counted(1)) * double(largest + smallest));
  return cost.leaf(range.primitives.size()) <=
         cost.split(range.box.half_area(), least, range.primitives.size());
}

/// A place on an axis in the upper half and a primitive in the lower one: numbers are ordered as places are.
using Key = std::uint64_t;
using Keys = std::array<Key, exact_size>;

Key key_of(float center, std::size_t primitive) {
  const auto bits = std::bit_cast<std::int32_t>(center + 0.0f);  // Not -0.
  const std::uint32_t ordered = std::uint32_t(bits) ^ (std::uint32_t(bits >> 31) | 0x80000000u);
  return Key(ordered) << 32 | primitive;
}
std::size_t primitive_of(Key key) { return std::size_t(std::uint32_t(key)); }

void order(Key& smaller, Key& larger) {
  const Key a = smaller, b = larger;
  smaller = a < b ? a : b;
  larger = a < b ? b : a;
}

/// Batcher's network: no branch, where a loop's would be mispredicted.
void sort(Keys& keys) {
  constexpr std::uint8_t network[][2] = {{0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3}, {4, 6},
                                         {5, 7}, {1, 2}, {5, 6}, {0, 4}, {1, 5}, {2, 6}, {3, 7},
                                         {2, 4}, {3, 5}, {1, 2}, {3, 4}, {5, 6}};
  for (const auto& [i, j] : network) order(keys[i], keys[j]);
}

/// The primitives of a small range in the order of their centres along an axis.
Keys ordered(std::span<const BuildPrimitive> primitives, int axis) {
  Keys keys;
  keys.fill(std::numeric_limits<Key>::max());
  for (std::size_t i = 0; i < primitives.size(); ++i) keys[i] = key_of(primitives[i].center()[axis], i);
  sort(keys);
  return keys;
}

std::size_t divide_exactly(const NodeRange& range, const BuildOptions& options, const CostModel& cost) {
  const std::span<BuildPrimitive> primitives = range.primitives;
  if (is_surely_leaf(range, options, cost)) return 0;
  std::array<Keys, 3> orders;
  Candidate best;
  for (int axis = 0; axis < 3; ++axis) {
    Keys& keys = orders[std::size_t(axis)];
    keys = ordered(primitives, axis);
    sweep(
        axis, primitives.size(), cost,
        [&](std::size_t i) { return BoxLanes::of(primitives[primitive_of(keys[i])]); },
        [](std::size_t) { return std::size_t{1}; }, best);
  }
  if (is_leaf_cheaper(range, options, cost, best)) return 0;
  std::array<BuildPrimitive, exact_size> copies;
  std::copy(primitives.begin(), primitives.end(), copies.begin());
  const Keys& keys = orders[std::size_t(best.axis)];
  for (std::size_t i = 0; i < primitives.size(); ++i) primitives[i] = copies[primitive_of(keys[i])];
  return best.item;
}

}  // namespace

std::size_t divide_by_sah(const NodeRange& range, const BuildOptions& options) {
  const CostModel cost(options);
  return range.primitives.size() <= exact_size ? divide_exactly(range, options, cost)
                                               : divide_by_bins(range, options, cost);
}

}  // namespace twinray
