// SPDX-License-Identifier: Apache-2.0
#include "core/light_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/angle.h"
#include "core/elementary.h"

namespace twinray {
namespace {

constexpr int bins = 12;
/// Below it a node is halved by numbers, so that no choice of splits makes the tree a list.
constexpr int most_levels = 48;

double angle_between(const Vec3& a, const Vec3& b) {
  const Vec3 c = cross(a, b);
  return 2 * pi_double * atan2_turns(double(length(c)), double(dot(a, b)));
}

/// How much of all directions light goes in, weighed by the cosine (Conty and Kulla 2018, equation 1).
double measure(const EmissionCone& cone) {
  const double o = cone.normals, w = std::min(o + cone.emission, pi_double);
  return 2 * pi_double * (1 - cos_radians(o)) +
         pi_double / 2 *
             (2 * w * sin_radians(o) - cos_radians(o - 2 * w) - 2 * o * sin_radians(o) + cos_radians(o));
}

/// What lights cost that are chosen together.
double cost(const LightBounds& bounds) {
  const double diagonal = double(length_squared(bounds.box.extent()));
  // Lights in a line, or all in one point, have no area: by the diagonal they still differ.
  return bounds.power * measure(bounds.cone) * (bounds.box.half_area() + diagonal);
}

Vec3 center(const LightBounds& light) { return (light.box.lower + light.box.upper) * 0.5f; }

/// Where lights are parted in two.
struct Split {
  int axis = -1;  ///< -1: nowhere.
  int bin = 0;    ///< The first of the second part.
  double cost = std::numeric_limits<double>::infinity();
};

int bin_of(float x, float lower, float extent) {
  return std::clamp(int(float(bins) * ((x - lower) / extent)), 0, bins - 1);
}

/// The best way to part the lights along an axis.
Split best_split(std::span<const LightBounds> lights, std::span<const std::uint32_t> order, const Aabb& box,
                 int axis) {
  const float lower = box.lower[axis], extent = box.extent()[axis];
  std::array<LightBounds, bins> bin;
  std::array<bool, bins> has{};
  for (const std::uint32_t i : order) {
    const auto at = std::size_t(bin_of(center(lights[i])[axis], lower, extent));
    bin[at] = has[at] ? twinray::together(bin[at], lights[i]) : lights[i];
    has[at] = true;
  }
  // Costs of all bins from each one on, then of all before it.
  std::array<double, bins> behind{};
  LightBounds sum;
  bool is_first = true;
  for (std::size_t i = bins; i-- > 1;) {
    if (has[i]) sum = is_first ? bin[i] : twinray::together(sum, bin[i]), is_first = false;
    behind[i] = is_first ? -1 : cost(sum);
  }
  Split best;
  is_first = true;
  for (std::size_t i = 1; i < bins; ++i) {
    if (has[i - 1]) sum = is_first ? bin[i - 1] : twinray::together(sum, bin[i - 1]), is_first = false;
    if (is_first || behind[i] < 0) continue;
    const double both = cost(sum) + behind[i];
    if (both < best.cost) best = {axis, int(i), both};
  }
  return best;
}

/// How many of the lights come first; they are put there.
std::size_t part(std::span<const LightBounds> lights, std::span<std::uint32_t> order, int level) {
  Aabb box;
  for (const std::uint32_t i : order) box.extend(center(lights[i]));
  Split best;
  for (int axis = 0; axis < 3 && level < most_levels; ++axis) {
    if (!(box.extent()[axis] > 0)) continue;
    const Split split = best_split(lights, order, box, axis);
    if (split.cost < best.cost) best = split;
  }
  if (best.axis < 0) return order.size() / 2;
  const float lower = box.lower[best.axis], extent = box.extent()[best.axis];
  const auto second = std::stable_partition(order.begin(), order.end(), [&](std::uint32_t i) {
    return bin_of(center(lights[i])[best.axis], lower, extent) < best.bin;
  });
  return std::size_t(second - order.begin());
}

/// cos(max(0, a - b)) and its sine, of angles in [0, pi].
float cos_less(float sin_a, float cos_a, float sin_b, float cos_b) {
  return cos_a > cos_b ? 1 : cos_a * cos_b + sin_a * sin_b;
}
float sin_less(float sin_a, float cos_a, float sin_b, float cos_b) {
  return cos_a > cos_b ? 0 : sin_a * cos_b - cos_a * sin_b;
}

float sine_of(float cosine) { return std::sqrt(std::max(0.0f, 1 - cosine * cosine)); }

}  // namespace

// Conty and Kulla 2018, algorithm 1.
EmissionCone together(EmissionCone a, EmissionCone b) {
  if (b.normals > a.normals) std::swap(a, b);
  a.emission = std::max(a.emission, b.emission);
  const double between = angle_between(a.axis, b.axis);
  if (std::min(between + b.normals, pi_double) <= a.normals) return a;
  const double normals = 0.5 * (a.normals + between + b.normals);
  const double turn = normals - a.normals, sine = sin_radians(between);
  // Axes that oppose each other have no plane to turn in.
  if (normals >= pi_double || !(sine > 1e-6)) return {a.axis, pi_double, a.emission};
  a.axis = normalize(a.axis * float(sin_radians(between - turn) / sine) +
                     b.axis * float(sin_radians(turn) / sine));
  a.normals = normals;
  return a;
}

LightBounds together(const LightBounds& a, const LightBounds& b) {
  LightBounds both{a.box, a.power + b.power, together(a.cone, b.cone)};
  both.box.extend(b.box.lower);
  both.box.extend(b.box.upper);
  return both;
}

LightNode::LightNode(const LightBounds& bounds)
    : center(twinray::center(bounds)),
      axis(bounds.cone.axis),
      squared_radius(0.25f * length_squared(bounds.box.extent())),
      power(float(bounds.power)),
      cos_normals(float(cos_radians(bounds.cone.normals))),
      sin_normals(float(sin_radians(bounds.cone.normals))),
      cos_emission(float(cos_radians(bounds.cone.emission))) {
  cos_emission = std::max(cos_emission - slack, 0.0f);
}

float LightNode::importance(const Receiver& receiver) const {
  const Vec3 towards = center - receiver.position;
  const float squared = length_squared(towards);
  if (!(squared > squared_radius)) return power / std::max(squared_radius, std::numeric_limits<float>::min());
  const Vec3 direction = towards / std::sqrt(squared);
  const float squared_sine = squared_radius / squared;  // Of the cone in which the box is seen.
  const float sin_box = std::sqrt(squared_sine), cos_box = std::sqrt(1 - squared_sine);

  const float cos_axis = -dot(axis, direction), sin_axis = sine_of(cos_axis);
  const float cos_beyond = cos_less(sin_axis, cos_axis, sin_normals, cos_normals);
  const float sin_beyond = sin_less(sin_axis, cos_axis, sin_normals, cos_normals);
  const float cos_least = cos_less(sin_beyond, cos_beyond, sin_box, cos_box);
  if (cos_least < cos_emission) return 0;

  const float cos_normal = receiver.is_in_medium() ? 1 : dot(receiver.normal, direction);
  const float cos_receiver = receiver.lets_light_through ? std::fabs(cos_normal) : cos_normal;
  const float cos_at_best = cos_less(sine_of(cos_receiver), cos_receiver, sin_box, cos_box) + slack;
  return std::max(power * cos_least * cos_at_best / squared, 0.0f);
}

LightTree::LightTree(std::span<const LightBounds> lights, Choice choice)
    : choice_(choice), leaf_of_(lights.size(), none) {
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < lights.size(); ++i)
    if (float(lights[i].power) > 0) order.push_back(i);
  nodes_.reserve(2 * order.size());
  if (!order.empty()) build(lights, order, none, 0);
}

LightBounds LightTree::build(std::span<const LightBounds> lights, std::span<std::uint32_t> order,
                             std::uint32_t parent, int level) {
  depth_ = std::max(depth_, level + 1);
  const auto index = std::uint32_t(nodes_.size());
  if (order.size() == 1) {
    nodes_.push_back({LightNode(lights[order[0]]), parent, none, order[0]});
    leaf_of_[order[0]] = index;
    return lights[order[0]];
  }
  nodes_.push_back({LightNode(LightBounds{}), parent});
  const std::size_t first = part(lights, order, level);
  const LightBounds left = build(lights, order.first(first), index, level + 1);
  nodes_[index].second = std::uint32_t(nodes_.size());
  const LightBounds both = together(left, build(lights, order.subspan(first), index, level + 1));
  nodes_[index].bounds = LightNode(both);
  return both;
}

float LightTree::weight(std::uint32_t node, const Receiver& receiver) const {
  const LightNode& bounds = nodes_[node].bounds;
  return choice_ == Choice::power ? bounds.power : bounds.importance(receiver);
}

float LightTree::first_probability(std::uint32_t node, const Receiver& receiver) const {
  const float first = weight(node + 1, receiver), second = weight(nodes_[node].second, receiver);
  const float sum = first + second;
  if (!(sum > 0)) return -1;
  return std::isfinite(sum) ? first / sum : 0.5f;
}

std::optional<LightTree::Pick> LightTree::pick(const Receiver& receiver, double u) const {
  if (nodes_.empty()) return std::nullopt;
  std::uint32_t node = 0;
  float probability = 1;
  double rest = u;  // Uniform in [0, 1) again after each choice.
  while (nodes_[node].light == none) {
    const float first = first_probability(node, receiver);
    if (first < 0) return std::nullopt;
    const bool is_first = rest < first;
    rest = is_first ? rest / first : (rest - first) / (1 - double(first));
    probability *= is_first ? first : 1 - first;
    node = is_first ? node + 1 : nodes_[node].second;
  }
  if (!(probability > 0)) return std::nullopt;
  return Pick{nodes_[node].light, probability, std::min(float(rest), 0x1.fffffep-1f)};
}

float LightTree::probability(std::uint32_t light, const Receiver& receiver) const {
  std::uint32_t node = leaf_of_[light];
  if (node == none) return 0;
  // From the root on, as pick() multiplies, so that the product is the same to the last bit.
  std::array<std::uint32_t, 128> path;
  std::size_t steps = 0;
  for (; nodes_[node].parent != none && steps < path.size(); node = nodes_[node].parent) path[steps++] = node;
  float product = 1;
  while (steps > 0) {
    const std::uint32_t child = path[--steps], parent = nodes_[child].parent;
    const float first = first_probability(parent, receiver);
    if (first < 0) return 0;
    product *= child == parent + 1 ? first : 1 - first;
  }
  return product;
}

}  // namespace twinray
