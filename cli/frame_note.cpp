// SPDX-License-Identifier: Apache-2.0
// The view is a pyramid, or a box where rays are parallel, cut off at the clip distances: six half spaces. A
// triangle is in it as a whole where its corners are, and in part where something is left of it after each
// half space has cut away what lies outside (Sutherland and Hodgman, "Reentrant Polygon Clipping", 1974).
#include "cli/frame_note.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace twinray {
namespace {

/// The points p with normal . p >= offset, in the camera's axes: right, up, forward.
struct HalfSpace {
  double x, y, z, offset;
};

struct Point {
  double x, y, z;
};

double distance(const HalfSpace& half, const Point& p) {
  return half.x * p.x + half.y * p.y + half.z * p.z - half.offset;
}

/// A half space through the origin.
HalfSpace unit(double x, double y, double z) {
  const double length = std::sqrt(x * x + y * y + z * z);
  return {x / length, y / length, z / length, 0};
}

class Frustum {
 public:
  explicit Frustum(const Camera& camera) : camera_(camera) {
    const double left = camera.frame_center.x - camera.tan_half_width,
                 right = camera.frame_center.x + camera.tan_half_width,
                 down = camera.frame_center.y - camera.tan_half_height,
                 up = camera.frame_center.y + camera.tan_half_height;
    const HalfSpace near{0, 0, 1, camera.clip_near}, far{0, 0, -1, -double(camera.clip_far)};
    if (camera.projection == Projection::orthographic)
      halves_ = {HalfSpace{1, 0, 0, left}, {-1, 0, 0, -right}, {0, 1, 0, down}, {0, -1, 0, -up}, near, far};
    else
      halves_ = {unit(1, 0, -left), unit(-1, 0, right), unit(0, 1, -down), unit(0, -1, up), near, far};
  }

  InView of(const Sphere& sphere) const {
    const Point center = seen_from_camera(sphere.center);
    InView result = InView::whole;
    for (const HalfSpace& half : halves_) {
      const double d = distance(half, center);
      if (d < -sphere.radius) return InView::nothing;
      if (d < sphere.radius) result = InView::part;
    }
    return result;
  }

  InView of(const Vec3& a, const Vec3& b, const Vec3& c) {
    polygon_ = {seen_from_camera(a), seen_from_camera(b), seen_from_camera(c)};
    InView result = InView::whole;
    for (const HalfSpace& half : halves_) {
      const bool is_inside = std::all_of(polygon_.begin(), polygon_.end(),
                                         [&](const Point& p) { return distance(half, p) >= 0; });
      if (is_inside) continue;
      result = InView::part;
      clip(half);
      if (polygon_.empty()) return InView::nothing;
    }
    return result;
  }

 private:
  Point seen_from_camera(const Vec3& p) const {
    const double x = double(p.x) - camera_.position.x, y = double(p.y) - camera_.position.y,
                 z = double(p.z) - camera_.position.z;
    const auto along = [&](const Vec3& axis) { return x * axis.x + y * axis.y + z * axis.z; };
    return {along(camera_.right), along(camera_.up), along(camera_.forward)};
  }

  void clip(const HalfSpace& half) {
    clipped_.clear();
    for (std::size_t i = 0; i < polygon_.size(); ++i) {
      const Point &p = polygon_[i], &q = polygon_[(i + 1) % polygon_.size()];
      const double dp = distance(half, p), dq = distance(half, q);
      if (dp >= 0) clipped_.push_back(p);
      if ((dp >= 0) == (dq >= 0)) continue;
      const double t = dp / (dp - dq);
      clipped_.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y), p.z + t * (q.z - p.z)});
    }
    std::swap(polygon_, clipped_);
  }

  const Camera& camera_;
  std::array<HalfSpace, 6> halves_;
  std::vector<Point> polygon_, clipped_;
};

/// What is known of the geometry so far: some of it in view, some of it not.
struct Seen {
  bool has_inside = false, has_outside = false;

  void add(InView seen) {
    has_inside = has_inside || seen != InView::nothing;
    has_outside = has_outside || seen != InView::whole;
  }
  bool is_decided() const { return has_inside && has_outside; }
};

void add(const Geometry& geometry, std::uint32_t shape, Frustum& frustum, Seen& seen) {
  if (const SphereSet* set = geometry.sphere_set(shape)) {
    for (const Sphere& sphere : set->spheres) seen.add(frustum.of(sphere));
    return;
  }
  const Mesh& mesh = *geometry.mesh(shape);
  for (const Triangle& t : mesh.triangles) {
    seen.add(frustum.of(mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]));
    if (seen.is_decided()) return;
  }
}

}  // namespace

InView in_view(const Camera& camera, const Geometry& geometry) {
  if (is_panorama(camera.projection)) return InView::whole;
  Frustum frustum(camera);
  Seen seen;
  for (std::uint32_t shape = 0; shape < geometry.shapes().size() && !seen.is_decided(); ++shape)
    add(geometry, shape, frustum, seen);
  if (!seen.has_outside) return InView::whole;
  return seen.has_inside ? InView::part : InView::nothing;
}

std::string frame_note(const Camera& camera, const Geometry& geometry) {
  switch (in_view(camera, geometry)) {
    case InView::nothing:
      return "the frame shows nothing of the scene; --view=whole shows all of it";
    case InView::part:
      return "part of the scene lies outside of the frame; --view=whole shows all of it";
    default:
      return "";
  }
}

}  // namespace twinray
