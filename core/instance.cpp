// SPDX-License-Identifier: Apache-2.0
#include "core/instance.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "core/coordinates.h"
#include "core/error.h"
#include "core/parallel.h"

namespace twinray {
namespace {

/// How far a hit may lie outside of the box that its prototype's box becomes: 64 u, with u = 2^-24, times
/// |A| |A^-1| (|o| + |b|) + |A| |box|. A is the transform's matrix, b its translation, o the ray's origin.
///
/// In the prototype's space let R be the largest component of the ray's origin or the box. Origin and
/// direction are rounded to float there: u R and 2 u R at the hit. The canonical test keeps a hit's parameter
/// within the interval of the prototype's box, which the slab test widens by 16 u (origin + box), 32 u R.
/// Together 35 u R, which the transform makes 35 u |A| R; and R is at most |A^-1| (|o| + |b|) + |box|. The
/// rest is left for what is rounded in double.
constexpr double instance_margin = 0x1p-18;

double largest_translation(const Transform& transform) {
  return std::max(std::fabs(transform.m[0][3]),
                  std::max(std::fabs(transform.m[1][3]), std::fabs(transform.m[2][3])));
}

bool is_finite(const Transform& transform) {
  for (const auto& row : transform.m)
    for (const double entry : row)
      if (!std::isfinite(entry)) return false;
  return true;
}

double max_abs(const Aabb& box) { return std::max(twinray::max_abs(box.lower), twinray::max_abs(box.upper)); }

float rounded_down(double x) {
  const auto near = float(x);
  return double(near) > x ? std::nextafter(near, -Aabb::infinity) : near;
}
float rounded_up(double x) { return -rounded_down(-x); }

/// The least float box around boxes that are moved by a transform, rounded outward; empty without any.
Aabb moved(const std::vector<Aabb>& boxes, const Transform& transform) {
  Aabb result;
  for (int row = 0; row < 3 && !boxes.empty(); ++row) {
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (const Aabb& box : boxes) {
      double center = transform.m[row][3], extent = 0;
      for (int axis = 0; axis < 3; ++axis) {
        const double lower = box.lower[axis], upper = box.upper[axis];
        center += transform.m[row][axis] * (0.5 * (lower + upper));
        extent += std::fabs(transform.m[row][axis]) * (0.5 * (upper - lower));
      }
      least = std::min(least, center - extent);
      most = std::max(most, center + extent);
    }
    result.lower[row] = rounded_down(least);
    result.upper[row] = rounded_up(most);
  }
  return result;
}

/// Moves each plane outward by `pad`, rounded outward.
Aabb widened(const Aabb& box, double pad) {
  Aabb result;
  for (int axis = 0; axis < 3; ++axis) {
    result.lower[axis] = rounded_down(box.lower[axis] - pad);
    result.upper[axis] = rounded_up(box.upper[axis] + pad);
  }
  return result;
}

/// What is known of an instance's matrix.
struct Matrix {
  double norm;  ///< As Transform::stretch().
  double inverse_norm;
  double translation;  ///< The largest component.

  Matrix(const Transform& to_world, const Transform& inverse)
      : norm(to_world.stretch()),
        inverse_norm(inverse.stretch()),
        translation(largest_translation(to_world)) {}

  /// The condition.
  double squash() const { return norm * inverse_norm; }
  /// By how much a box is widened in a scene of this reach; `size` is the prototype's.
  double pad(double reach, double size) const {
    return instance_margin * (squash() * (reach + translation) + norm * size);
  }
};

/// Why no instance may have a transform with this inverse; empty where it may.
std::string fault_of(const Transform& to_world, const Transform& inverse) {
  if (!is_finite(to_world)) return "its transform is not finite";
  const Matrix matrix(to_world, inverse);
  if (to_world.determinant() == 0 || !is_finite(inverse) || matrix.squash() > max_instance_squash)
    return fmt::format(
        "its transform flattens; it may stretch no direction more than {:g} times as much as another one",
        max_instance_squash);
  if (matrix.norm > max_instance_scale || matrix.inverse_norm > max_instance_scale)
    return fmt::format("its transform scales by {:g}; scales must lie between {:g} and {:g}",
                       matrix.norm > max_instance_scale ? matrix.norm : 1 / matrix.inverse_norm,
                       1 / max_instance_scale, max_instance_scale);
  return {};
}

/// Boxes that hold the primitives of each prototype.
using Parts = std::vector<std::vector<Aabb>>;

/// Sets an instance with a box that is not widened yet; returns what is wrong with it, or nothing.
std::string place(const Instance& instance, const Parts& parts, PlacedInstance& placed) {
  const auto& [prototype, to_world] = instance;
  if (prototype >= parts.size())
    return fmt::format(" is one of prototype {}; there are {}", prototype, parts.size());
  placed = {to_world.inverse(), {}, prototype};
  if (const std::string fault = fault_of(to_world, placed.to_object); !fault.empty()) return ": " + fault;
  placed.box = moved(parts[prototype], to_world);
  if (!placed.box.is_empty() && !(max_abs(placed.box) <= max_coordinate))
    return fmt::format(": it reaches to {:g}; coordinates must be within +-{:g}", max_abs(placed.box),
                       max_coordinate);
  return {};
}

/// Calls work(i) for each instance, on all threads.
template <typename Work>
void for_each_instance(std::size_t count, const Work& work) {
  constexpr std::size_t instances_a_task = 1024;
  parallel_for(count, instances_a_task, 0, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) work(i);
  });
}

/// All of them. Where some are faulty the error names the first one, whichever thread meets which.
std::vector<PlacedInstance> place_all(const std::vector<Instance>& instances, const Parts& parts) {
  std::vector<PlacedInstance> placed(instances.size());
  std::atomic<std::size_t> first_faulty = instances.size();
  for_each_instance(instances.size(), [&](std::size_t i) {
    if (place(instances[i], parts, placed[i]).empty()) return;
    std::size_t known = first_faulty;
    while (i < known && !first_faulty.compare_exchange_weak(known, i)) continue;
  });
  if (const std::size_t i = first_faulty; i < instances.size())
    throw Error(fmt::format("instance {}{}", i, place(instances[i], parts, placed[i])));
  return placed;
}

}  // namespace

bool can_place(const Transform& to_world) { return fault_of(to_world, to_world.inverse()).empty(); }

PlacedInstances::PlacedInstances(std::vector<Instance> instances, const Parts& parts, const Aabb& direct)
    : instances_(std::move(instances)), placed_(place_all(instances_, parts)) {
  for (const PlacedInstance& placed : placed_) bounds_.extend(placed.box);
  Aabb all = direct;
  all.extend(bounds_);
  const double reach = all.is_empty() ? 0 : max_abs(all);
  std::vector<double> sizes(parts.size());  // Of the prototypes.
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (const Aabb& box : parts[i]) sizes[i] = std::max(sizes[i], max_abs(box));
  std::vector<double> squashes(placed_.size());
  for_each_instance(placed_.size(), [&](std::size_t i) {
    PlacedInstance& placed = placed_[i];
    const Matrix matrix(instances_[i].to_world, placed.to_object);
    squashes[i] = matrix.squash();
    if (!placed.box.is_empty()) placed.box = widened(placed.box, matrix.pad(reach, sizes[placed.prototype]));
  });
  double most = 1;
  for (const double squash : squashes) most = std::max(most, squash);
  reach_ = float(reach);
  far_margin_ = float(instance_margin * most);
}

}  // namespace twinray
