// SPDX-License-Identifier: Apache-2.0
// The corners of all faces are sorted by their vertex and the one that follows it. So the corners of a vertex
// stand together, a directed edge is found by binary search, and no half-edges need to be linked.
#include "io/cs184/normals.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace twinray {
namespace {

constexpr std::uint32_t none = 0xffffffff;

/// A corner of a face, with its neighbours in that face.
struct Corner {
  std::uint32_t vertex, next, after_next, previous;

  friend bool operator<(const Corner& a, const Corner& b) {
    return a.vertex != b.vertex ? a.vertex < b.vertex : a.next < b.next;
  }
};

DoublePoint minus(const DoublePoint& a, const DoublePoint& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

DoublePoint plus(const DoublePoint& a, const DoublePoint& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

DoublePoint cross(const DoublePoint& a, const DoublePoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vec3 unit_or_zero(const DoublePoint& v) {
  const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  if (!(length > 0) || !std::isfinite(length)) return {0, 0, 0};
  return {float(v[0] / length), float(v[1] / length), float(v[2] / length)};
}

std::vector<Corner> sorted_corners(const FaceList& faces) {
  std::vector<Corner> corners;
  corners.reserve(faces.corners.size());
  std::size_t begin = 0;
  for (const std::size_t end : faces.ends) {
    const std::size_t count = end - begin;
    const auto at = [&](std::size_t i) { return faces.corners[begin + i % count]; };
    for (std::size_t i = 0; i < count; ++i)
      corners.push_back({at(i), at(i + 1), at(i + 2), at(i + count - 1)});
    begin = end;
  }
  std::sort(corners.begin(), corners.end());
  return corners;
}

class Surface {
 public:
  Surface(const FaceList& faces, std::span<const DoublePoint> positions)
      : positions_(positions),
        corners_(sorted_corners(faces)),
        begins_(positions.size() + 1),
        border_(positions.size(), none) {
    for (const Corner& corner : corners_) ++begins_[corner.vertex + 1];
    for (std::size_t v = 0; v < positions.size(); ++v) begins_[v + 1] += begins_[v];
    fault_ = find_fault(faces);
  }

  const std::string& fault() const { return fault_; }

  Vec3 normal(std::uint32_t vertex) const {
    if (fault_.empty() && border_[vertex] != none) return border_normal(vertex, border_[vertex]);
    DoublePoint sum{};
    for (const Corner& corner : around(vertex)) {
      const DoublePoint to_b = to(vertex, corner.next), to_c = to(vertex, corner.after_next);
      sum = plus(sum, cross(to_b, to_c));
    }
    return unit_or_zero(sum);
  }

 private:
  std::span<const Corner> around(std::uint32_t vertex) const {
    return {corners_.data() + begins_[vertex], corners_.data() + begins_[vertex + 1]};
  }
  DoublePoint to(std::uint32_t from, std::uint32_t to) const {
    return minus(positions_[to], positions_[from]);
  }
  /// The corner whose face has the edge from one vertex to the other.
  const Corner* edge(std::uint32_t from, std::uint32_t to) const {
    const auto corners = around(from);
    const auto found = std::lower_bound(corners.begin(), corners.end(), Corner{from, to, none, none});
    return found != corners.end() && found->next == to ? &*found : nullptr;
  }

  Vec3 border_normal(std::uint32_t vertex, std::uint32_t before) const {
    DoublePoint sum = to(vertex, border_[before]);
    for (const Corner& corner : around(before)) sum = plus(sum, to(vertex, corner.next));
    return unit_or_zero(cross(to(vertex, before), sum));
  }

  /// Finds the borders on its way.
  std::string find_fault(const FaceList& faces);
  std::string find_repeated_corner(const FaceList& faces) const;
  bool is_fan(std::uint32_t vertex);

  std::span<const DoublePoint> positions_;
  std::vector<Corner> corners_;
  std::vector<std::size_t> begins_;    ///< Where the corners of each vertex begin.
  std::vector<std::uint32_t> border_;  ///< The vertex before on the border; none within the surface.
  std::string fault_;
};

std::string Surface::find_repeated_corner(const FaceList& faces) const {
  std::size_t begin = 0;
  std::vector<std::uint32_t> face;
  for (const std::size_t end : faces.ends) {
    face.assign(faces.corners.begin() + std::ptrdiff_t(begin), faces.corners.begin() + std::ptrdiff_t(end));
    std::sort(face.begin(), face.end());
    if (const auto twice = std::adjacent_find(face.begin(), face.end()); twice != face.end())
      return fmt::format("a face has the vertex {} twice", *twice);
    begin = end;
  }
  return "";
}

std::string Surface::find_fault(const FaceList& faces) {
  if (const std::string fault = find_repeated_corner(faces); !fault.empty()) return fault;
  for (std::size_t i = 1; i < corners_.size(); ++i)
    if (!(corners_[i - 1] < corners_[i]))
      return fmt::format("two faces have the edge from vertex {} to vertex {} in the same direction",
                         corners_[i].vertex, corners_[i].next);
  for (std::uint32_t vertex = 0; vertex < positions_.size(); ++vertex)
    if (!is_fan(vertex)) return fmt::format("the faces around vertex {} are not one fan", vertex);
  return "";
}

/// Turns around the vertex, from the border where it lies on one, and counts the corners on the way.
bool Surface::is_fan(std::uint32_t vertex) {
  const auto corners = around(vertex);
  const Corner* first = corners.data();
  for (const Corner& corner : corners)
    if (!edge(corner.next, vertex)) first = &corner;
  std::size_t seen = 0;
  for (const Corner* at = first; seen < corners.size();) {
    ++seen;
    const Corner* next = edge(vertex, at->previous);
    if (!next) border_[vertex] = at->previous;
    if (!next || next == first) break;
    at = next;
  }
  return seen == corners.size();
}

}  // namespace

VertexNormals cs184_normals(const FaceList& faces, std::span<const DoublePoint> positions) {
  const Surface surface(faces, positions);
  VertexNormals result;
  result.fault = surface.fault();
  result.normals.reserve(positions.size());
  for (std::uint32_t vertex = 0; vertex < positions.size(); ++vertex)
    result.normals.push_back(surface.normal(vertex));
  return result;
}

}  // namespace twinray
