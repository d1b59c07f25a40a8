// SPDX-License-Identifier: Apache-2.0
#include "io/polygon.h"

#include <cmath>
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

/// Seen along the mean normal's largest component, such that the polygon runs counter-clockwise (Newell's
/// sums).
std::vector<Point2> flatten(std::span<const Vec3> corners) {
  double normal[3] = {0, 0, 0};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 &a = corners[i], &b = corners[(i + 1) % corners.size()];
    normal[0] += (double(a.y) - b.y) * (double(a.z) + b.z);
    normal[1] += (double(a.z) - b.z) * (double(a.x) + b.x);
    normal[2] += (double(a.x) - b.x) * (double(a.y) + b.y);
  }
  int axis = 0;
  for (int i = 1; i < 3; ++i)
    if (std::fabs(normal[i]) > std::fabs(normal[axis])) axis = i;
  const double sign = normal[axis] < 0 ? -1 : 1;
  std::vector<Point2> points;
  for (const Vec3& c : corners) points.push_back({sign * c[(axis + 1) % 3], double(c[(axis + 2) % 3])});
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

class EarClipper {
 public:
  explicit EarClipper(const std::vector<Point2>& points) : points_(points), left_(points.size()) {
    std::iota(left_.begin(), left_.end(), 0u);
  }

  std::vector<std::array<std::uint32_t, 3>> run() {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    while (left_.size() > 3) {
      const std::size_t ear = find_ear();
      triangles.push_back({at(ear + left_.size() - 1), at(ear), at(ear + 1)});
      left_.erase(left_.begin() + std::ptrdiff_t(ear));
    }
    triangles.push_back({left_[0], left_[1], left_[2]});
    return triangles;
  }

 private:
  std::uint32_t at(std::size_t i) const { return left_[i % left_.size()]; }

  /// The corner to cut off: an ear, or 1 where there is none.
  std::size_t find_ear() const {
    for (std::size_t i = 0; i < left_.size(); ++i)
      if (is_ear(i)) return i;
    return 1;
  }

  bool is_ear(std::size_t i) const {
    const std::uint32_t ia = at(i + left_.size() - 1), ib = at(i), ic = at(i + 1);
    const Point2 &a = points_[ia], &b = points_[ib], &c = points_[ic];
    if (area2(a, b, c) <= 0) return false;
    for (const std::uint32_t other : left_) {
      if (other == ia || other == ib || other == ic) continue;
      const Point2& p = points_[other];
      if (area2(a, b, p) >= 0 && area2(b, c, p) >= 0 && area2(c, a, p) >= 0) return false;
    }
    return true;
  }

  const std::vector<Point2>& points_;
  std::vector<std::uint32_t> left_;  ///< The corners not yet cut off.
};

}  // namespace

std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const Vec3> corners) {
  std::vector<std::array<std::uint32_t, 3>> fan;
  for (std::uint32_t i = 2; i < corners.size(); ++i) fan.push_back({0, i - 1, i});
  if (corners.size() == 3) return fan;
  const std::vector<Point2> points = flatten(corners);
  return is_convex(points) ? fan : EarClipper(points).run();
}

}  // namespace twinray
