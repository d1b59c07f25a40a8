// SPDX-License-Identifier: Apache-2.0
// Binned search for the split of least cost.
//
// On each axis the centres' box is cut into bins of equal width; each bin collects the count and the box of
// the primitives whose centres it holds. A sweep from the right gives the boxes of all right sides, a sweep
// from the left meets them.
#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "accel/bvh/cost_model.h"
#include "accel/bvh/split.h"
#include "core/parallel.h"

namespace twinray {
namespace {

constexpr int max_bins = 256;

struct Bin {
  Aabb box;
  std::size_t count = 0;

  void extend(const Bin& other) {
    box.extend(other.box);
    count += other.count;
  }
  double weighted_area(const CostModel& cost) const { return box.half_area() * cost.counted(count); }
};

/// Which bin a centre falls into, on each axis. In double: an extent of 10^12 and one of 10^-40 both have a
/// finite inverse, and no difference of floats overflows.
class Binning {
 public:
  Binning(const Aabb& centers, int bins) : bins_(bins) {
    for (int axis = 0; axis < 3; ++axis) {
      lower_[axis] = centers.lower[axis];
      const double extent = double(centers.upper[axis]) - lower_[axis];
      scale_[axis] = extent > 0 ? bins / extent : 0;
    }
  }
  int bin(const Vec3& center, int axis) const {
    return std::min(bins_ - 1, int((double(center[axis]) - lower_[axis]) * scale_[axis]));
  }
  int bins() const { return bins_; }
  bool is_flat(int axis) const { return scale_[axis] == 0; }

 private:
  int bins_;
  std::array<double, 3> lower_, scale_;
};

using Bins = std::array<std::array<Bin, max_bins>, 3>;

void fill(Bins& bins, const Binning& binning, std::span<const BuildPrimitive> primitives) {
  for (auto& axis_bins : bins) std::fill_n(axis_bins.begin(), binning.bins(), Bin{});
  for (const BuildPrimitive& primitive : primitives) {
    const Vec3 center = primitive.center();
    for (std::size_t axis = 0; axis < 3; ++axis)
      bins[axis][std::size_t(binning.bin(center, int(axis)))].extend({primitive.box, 1});
  }
}

/// The same bits as fill: fixed parts, joined in their order.
void fill_in_parallel(Bins& bins, const Binning& binning, std::span<const BuildPrimitive> primitives) {
  const std::size_t part = std::max(parallel_range / 4, primitives.size() / 64 + 1);
  std::vector<Bins> parts((primitives.size() + part - 1) / part);
  parallel_for(parts.size(), 1, 0, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      fill(parts[i], binning, primitives.subspan(i * part, std::min(part, primitives.size() - i * part)));
  });
  fill(bins, binning, {});
  for (const Bins& other : parts)
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::size_t i = 0; i < std::size_t(binning.bins()); ++i) bins[axis][i].extend(other[axis][i]);
}

/// Between bin - 1 and bin of an axis.
struct Candidate {
  int axis = 0, bin = 0;
  double weighted_area = std::numeric_limits<double>::infinity();
};

void sweep(const std::array<Bin, max_bins>& bins, int count, int axis, const CostModel& cost,
           Candidate& best) {
  std::array<double, max_bins> right;
  Bin side;
  for (int i = count - 1; i > 0; --i) {
    side.extend(bins[std::size_t(i)]);
    right[std::size_t(i)] = side.count > 0 ? side.weighted_area(cost) : Candidate{}.weighted_area;
  }
  side = {};
  for (int i = 1; i < count; ++i) {
    side.extend(bins[std::size_t(i - 1)]);
    const double sum = side.weighted_area(cost) + right[std::size_t(i)];
    if (side.count > 0 && sum < best.weighted_area) best = {axis, i, sum};
  }
}

Candidate cheapest(const NodeRange& range, const Binning& binning, const CostModel& cost) {
  Bins bins;
  if (range.primitives.size() < parallel_range)
    fill(bins, binning, range.primitives);
  else
    fill_in_parallel(bins, binning, range.primitives);
  Candidate best;
  for (int axis = 0; axis < 3; ++axis)
    if (!binning.is_flat(axis)) sweep(bins[std::size_t(axis)], binning.bins(), axis, cost, best);
  return best;
}

}  // namespace

std::size_t divide_by_sah(const NodeRange& range, const BuildOptions& options) {
  const std::size_t count = range.primitives.size();
  // A small node needs few bins: four for each primitive part almost all centres that differ.
  const Binning binning(range.centers, int(std::min<std::size_t>(std::size_t(options.bvh_bins), 4 * count)));
  const CostModel cost(options);
  const Candidate best = cheapest(range, binning, cost);
  if (count <= std::size_t(options.max_leaf_size) &&
      cost.leaf(count) <= cost.split(range.box.half_area(), best.weighted_area, count))
    return 0;
  const auto first_of_second = std::partition(
      range.primitives.begin(), range.primitives.end(),
      [&](const BuildPrimitive& primitive) { return binning.bin(primitive.center(), best.axis) < best.bin; });
  return std::size_t(first_of_second - range.primitives.begin());
}

}  // namespace twinray
