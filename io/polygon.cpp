// SPDX-License-Identifier: Apache-2.0
#include "io/polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace twinray {
namespace {

struct Point2 {
  double x, y;
};

/// Twice the signed area; positive where a, b, c run counter-clockwise.
double area2(const Point2& a, const Point2& b, const Point2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Newell's sums: along the normal, as long as twice the area.
std::array<double, 3> mean_normal(std::span<const Vec3> ring) {
  std::array<double, 3> normal{};
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec3 &a = ring[i], &b = ring[(i + 1) % ring.size()];
    normal[0] += (double(a.y) - b.y) * (double(a.z) + b.z);
    normal[1] += (double(a.z) - b.z) * (double(a.x) + b.x);
    normal[2] += (double(a.x) - b.x) * (double(a.y) + b.y);
  }
  return normal;
}

/// All corners seen along the largest component of the outline's mean normal, such that it runs
/// counter-clockwise.
std::vector<Point2> flatten(std::span<const Vec3> corners, std::size_t outline) {
  const auto normal = mean_normal(corners.first(outline));
  std::size_t axis = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (std::fabs(normal[i]) > std::fabs(normal[axis])) axis = i;
  const double sign = normal[axis] < 0 ? -1 : 1;
  const int first = int(axis + 1) % 3, second = int(axis + 2) % 3;
  std::vector<Point2> points;
  for (const Vec3& c : corners) points.push_back({sign * c[first], double(c[second])});
  return points;
}

bool is_convex(const std::vector<Point2>& p) {
  const std::size_t n = p.size();
  int turns = 0;  // where x turns back: a convex polygon does so twice
  double previous = p[0].x - p[n - 1].x;
  for (std::size_t i = 0; i < n; ++i) {
    if (area2(p[i], p[(i + 1) % n], p[(i + 2) % n]) < 0) return false;
    const double step = p[(i + 1) % n].x - p[i].x;
    if (step == 0) continue;
    turns += (step < 0) != (previous < 0);
    previous = step;
  }
  return turns <= 2;
}

/// A closed line of corners; bridges make some occur twice.
using Ring = std::vector<std::uint32_t>;

/// Joins holes to an outline that runs counter-clockwise.
class Bridges {
 public:
  Bridges(const std::vector<Point2>& points, Ring outline) : points_(points), ring_(std::move(outline)) {}

  /// The holes from right to left: then each bridge, which goes to the right, meets those made before.
  Ring join(std::vector<Ring> holes) {
    for (Ring& hole : holes) turn(hole);
    std::sort(holes.begin(), holes.end(),
              [&](const Ring& a, const Ring& b) { return points_[a[0]].x > points_[b[0]].x; });
    for (const Ring& hole : holes) add(hole);
    return ring_;
  }

 private:
  /// Makes a hole run clockwise, and start at its rightmost corner.
  void turn(Ring& hole) const {
    double area = 0;
    for (std::size_t i = 1; i + 1 < hole.size(); ++i)
      area += area2(points_[hole[0]], points_[hole[i]], points_[hole[i + 1]]);
    if (area > 0) std::reverse(hole.begin(), hole.end());
    const auto rightmost = std::max_element(hole.begin(), hole.end(), [&](std::uint32_t a, std::uint32_t b) {
      return points_[a].x < points_[b].x;
    });
    std::rotate(hole.begin(), rightmost, hole.end());
  }

  void add(const Ring& hole) {
    const std::size_t at = bridge_end(points_[hole[0]]);
    if (at == ring_.size()) return;
    Ring detour(hole);
    detour.push_back(hole[0]);
    detour.push_back(ring_[at]);
    ring_.insert(ring_.begin() + std::ptrdiff_t(at) + 1, detour.begin(), detour.end());
  }

  const Point2& at(std::size_t i) const { return points_[ring_[i % ring_.size()]]; }

  /// The place in the ring of a corner that is seen from `eye`; the ring's size where the eye is outside.
  std::size_t bridge_end(const Point2& eye) const {
    double nearest = std::numeric_limits<double>::infinity();
    std::size_t edge = ring_.size();  // the first that is met to the right
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      const Point2 &a = at(i), &b = at(i + 1);
      if (!(a.y <= eye.y && eye.y < b.y)) continue;
      const double x = a.x + (eye.y - a.y) / (b.y - a.y) * (b.x - a.x);
      if (x < eye.x || x >= nearest) continue;
      nearest = x;
      edge = i;
    }
    if (edge == ring_.size()) return edge;
    const std::size_t end = at(edge).x > at(edge + 1).x ? edge : (edge + 1) % ring_.size();
    return first_in_the_way(eye, {nearest, eye.y}, end);
  }

  /// Of the corners within the triangle of eye, hit and ring end, that with the least angle to the ray.
  std::size_t first_in_the_way(const Point2& eye, const Point2& hit, std::size_t end) const {
    const Point2& p = at(end);
    std::size_t best = end;
    const auto slope_of = [&](const Point2& q) { return std::fabs(q.y - eye.y) / (q.x - eye.x); };
    double least = p.x > eye.x ? slope_of(p) : std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      const Point2& q = at(i);
      if (ring_[i] == ring_[end] || q.x <= eye.x || !is_within(q, eye, hit, p) || !sees(i, eye)) continue;
      const double slope = slope_of(q);
      if (slope > least || (slope == least && q.x >= at(best).x)) continue;
      least = slope;
      best = i;
    }
    return best;
  }

  static bool is_within(const Point2& q, const Point2& a, const Point2& b, const Point2& c) {
    const double d0 = area2(a, b, q), d1 = area2(b, c, q), d2 = area2(c, a, q);
    return (d0 >= 0 && d1 >= 0 && d2 >= 0) || (d0 <= 0 && d1 <= 0 && d2 <= 0);
  }

  /// Whether the eye lies between the two edges that meet there, on the inner side.
  bool sees(std::size_t i, const Point2& eye) const {
    const Point2 &before = at(i + ring_.size() - 1), &corner = at(i), &after = at(i + 1);
    const bool left_of_first = area2(before, corner, eye) > 0, left_of_second = area2(corner, after, eye) > 0;
    return area2(before, corner, after) >= 0 ? left_of_first && left_of_second
                                             : left_of_first || left_of_second;
  }

  const std::vector<Point2>& points_;
  Ring ring_;
};

/// How well a corner can be cut off, the better the greater: one that turns inward, or has others within its
/// triangle, not at all; a flat one without loss of area; one whose triangle others touch; an ear, whose
/// triangle is free of others.
enum class Ear : char { none, flat, touched, free };

/// Keeps, for each place of the ring that is left, how good an ear it is: cutting one off changes that for
/// its two neighbours only, so that all takes quadratic time.
class EarClipper {
 public:
  EarClipper(const std::vector<Point2>& points, const Ring& ring)
      : points_(points), ring_(ring), before_(ring.size()), after_(ring.size()), ears_(ring.size()) {
    const auto n = std::uint32_t(ring.size());
    for (std::uint32_t i = 0; i < n; ++i) {
      before_[i] = (i + n - 1) % n;
      after_[i] = (i + 1) % n;
    }
    for (std::uint32_t i = 0; i < n; ++i) ears_[i] = judge(i);
  }

  std::vector<std::array<std::uint32_t, 3>> run() {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::uint32_t i = 0;
    for (std::size_t left = ring_.size(); left > 3; --left) {
      i = best_ear(i, left);
      triangles.push_back(triangle(i));
      i = cut_off(i);
    }
    triangles.push_back(triangle(i));
    return triangles;
  }

 private:
  std::array<std::uint32_t, 3> triangle(std::uint32_t i) const {
    return {ring_[before_[i]], ring_[i], ring_[after_[i]]};
  }

  /// The next free one from i on; where there is none the next of the best that there are.
  std::uint32_t best_ear(std::uint32_t i, std::size_t left) const {
    std::uint32_t best = i, at = i;
    for (std::size_t steps = 0; steps < left && ears_[best] != Ear::free; ++steps, at = after_[at])
      if (ears_[at] > ears_[best]) best = at;
    return best;
  }

  /// Takes a place out of the ring; returns the one behind it.
  std::uint32_t cut_off(std::uint32_t i) {
    const std::uint32_t a = before_[i], b = after_[i];
    after_[a] = b;
    before_[b] = a;
    ears_[a] = judge(a);
    ears_[b] = judge(b);
    return b;
  }

  Ear judge(std::uint32_t i) const {
    const auto [ia, ib, ic] = triangle(i);
    const Point2 &a = points_[ia], &b = points_[ib], &c = points_[ic];
    const double area = area2(a, b, c);
    if (area <= 0) return area < 0 ? Ear::none : Ear::flat;
    Ear result = Ear::free;
    for (std::uint32_t j = after_[after_[i]]; j != before_[i]; j = after_[j]) {
      const std::uint32_t other = ring_[j];
      if (other == ia || other == ib || other == ic) continue;
      const Point2& p = points_[other];
      const double least = std::min({area2(a, b, p), area2(b, c, p), area2(c, a, p)});
      if (least > 0) return Ear::none;
      if (least == 0) result = Ear::touched;
    }
    return result;
  }

  const std::vector<Point2>& points_;
  const Ring& ring_;
  Ring before_, after_;  ///< Places in the ring.
  std::vector<Ear> ears_;
};

Ring ring_of(std::size_t begin, std::size_t end) {
  Ring ring(end - begin);
  std::iota(ring.begin(), ring.end(), std::uint32_t(begin));
  return ring;
}

}  // namespace

std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const Vec3> corners,
                                                      std::span<const std::size_t> hole_starts) {
  const std::size_t outline = hole_starts.empty() ? corners.size() : hole_starts[0];
  std::vector<std::array<std::uint32_t, 3>> fan;
  for (std::uint32_t i = 2; i < outline; ++i) fan.push_back({0, i - 1, i});
  if (corners.size() == 3) return fan;
  const std::vector<Point2> points = flatten(corners, outline);
  if (hole_starts.empty() && is_convex(points)) return fan;
  std::vector<Ring> holes;
  for (std::size_t i = 0; i < hole_starts.size(); ++i)
    holes.push_back(
        ring_of(hole_starts[i], i + 1 < hole_starts.size() ? hole_starts[i + 1] : corners.size()));
  return EarClipper(points, Bridges(points, ring_of(0, outline)).join(std::move(holes))).run();
}

}  // namespace twinray
