// SPDX-License-Identifier: Apache-2.0
#include "core/loop_subdivision.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "core/angle.h"
#include "core/elementary.h"

namespace twinray {
namespace {

constexpr std::uint32_t no_half_edge = std::numeric_limits<std::uint32_t>::max();

/// The neighbours of a vertex, counter-clockwise; of one at the surface's end, from one end to the other.
struct Ring {
  std::vector<std::uint32_t> vertices;
  bool is_open = false;

  std::uint32_t operator[](std::size_t i) const { return vertices[i]; }
  std::uint32_t last() const { return vertices.back(); }
  std::size_t size() const { return vertices.size(); }
};

/// Who is beside whom in a mesh. Half-edge 3 t + k runs in triangle t from its vertex k to the next one.
class Surface {
 public:
  Surface(std::span<const Triangle> triangles, std::size_t vertices)
      : triangles_(triangles),
        twins_(3 * triangles.size(), no_half_edge),
        edges_(3 * triangles.size()),
        leaving_(vertices, no_half_edge) {
    is_surface_ = pair_half_edges();
    if (is_surface_) find_leaving();
  }

  /// Of every vertex the triangles hang together, too.
  bool is_surface() const {
    if (!is_surface_) return false;
    std::vector<std::uint32_t> counts(leaving_.size());
    for (const Triangle& triangle : triangles_)
      for (const std::uint32_t vertex : triangle) ++counts[vertex];
    Ring ring;
    for (std::uint32_t vertex = 0; vertex < leaving_.size(); ++vertex) {
      if (counts[vertex] == 0) continue;
      find_ring(vertex, ring);
      if (ring.size() != counts[vertex] + (ring.is_open ? 1 : 0)) return false;
    }
    return true;
  }

  std::uint32_t edge_count() const { return edge_count_; }
  /// The number of a half-edge's edge.
  std::uint32_t edge(std::size_t half_edge) const { return edges_[half_edge]; }
  /// That in the triangle beside, or none.
  std::uint32_t twin(std::size_t half_edge) const { return twins_[half_edge]; }
  std::uint32_t from(std::size_t half_edge) const { return triangles_[half_edge / 3][half_edge % 3]; }
  std::uint32_t to(std::size_t half_edge) const { return from(next(half_edge)); }
  /// The vertex of its triangle that it does not touch.
  std::uint32_t opposite(std::size_t half_edge) const { return from(before(half_edge)); }

  /// Empty for a vertex without triangles.
  void find_ring(std::uint32_t vertex, Ring& ring) const {
    ring.vertices.clear();
    ring.is_open = false;
    const std::uint32_t first = leaving_[vertex];
    for (std::uint32_t spoke = first; spoke != no_half_edge;) {
      ring.vertices.push_back(to(spoke));
      const std::size_t arriving = before(spoke);
      spoke = twins_[arriving];
      if (spoke == first) return;
      if (spoke == no_half_edge) {
        ring.vertices.push_back(from(arriving));
        ring.is_open = true;
      }
    }
  }

 private:
  static std::size_t next(std::size_t half_edge) {
    return half_edge % 3 == 2 ? half_edge - 2 : half_edge + 1;
  }
  static std::size_t before(std::size_t half_edge) {
    return half_edge % 3 == 0 ? half_edge + 2 : half_edge - 1;
  }

  bool pair_half_edges() {
    using Entry = std::pair<std::uint64_t, std::uint32_t>;  // An edge by its ends, and a half of it.
    std::vector<Entry> entries;
    entries.reserve(edges_.size());
    for (std::size_t half = 0; half < edges_.size(); ++half) {
      const auto [low, high] = std::minmax({from(half), to(half)});
      if (low == high) return false;
      entries.emplace_back(std::uint64_t(low) << 32 | high, std::uint32_t(half));
    }
    std::sort(entries.begin(), entries.end());
    for (std::size_t i = 0; i < entries.size(); ++edge_count_) {
      const auto& [ends, half] = entries[i];
      edges_[half] = edge_count_;
      if (++i == entries.size() || entries[i].first != ends) continue;
      const std::uint32_t other = entries[i].second;
      if (from(half) == from(other)) return false;
      if (++i < entries.size() && entries[i].first == ends) return false;
      edges_[other] = edge_count_;
      twins_[half] = other;
      twins_[other] = half;
    }
    return true;
  }

  /// Of each vertex a half-edge that leaves it: at the surface's end the one from which all others are found.
  void find_leaving() {
    for (std::size_t half = 0; half < edges_.size(); ++half) {
      std::uint32_t& leaving = leaving_[from(half)];
      if (leaving == no_half_edge || twins_[half] == no_half_edge) leaving = std::uint32_t(half);
    }
  }

  std::span<const Triangle> triangles_;
  std::vector<std::uint32_t> twins_, edges_, leaving_;
  std::uint32_t edge_count_ = 0;
  bool is_surface_ = false;
};

Vec3 sum_of(const std::vector<Vec3>& positions, const Ring& ring) {
  Vec3 sum;
  for (const std::uint32_t vertex : ring.vertices) sum += positions[vertex];
  return sum;
}

/// The part of each neighbour in a vertex's next place: Warren's, where it has n of them.
float neighbor_weight(std::size_t n) { return n == 3 ? 3.0f / 16 : 3.0f / (8 * float(n)); }

/// A vertex and its neighbours, these with a weight each; at the surface's end with another, and only the two
/// along it.
Vec3 mixed(const std::vector<Vec3>& positions, std::uint32_t vertex, const Ring& ring, float weight,
           float weight_at_end) {
  const Vec3& own = positions[vertex];
  if (ring.is_open)
    return own * (1 - 2 * weight_at_end) + (positions[ring[0]] + positions[ring.last()]) * weight_at_end;
  return own * (1 - float(ring.size()) * weight) + sum_of(positions, ring) * weight;
}

Vec3 next_place(const std::vector<Vec3>& positions, std::uint32_t vertex, const Ring& ring) {
  return mixed(positions, vertex, ring, neighbor_weight(ring.size()), 1.0f / 8);
}

Vec3 limit_place(const std::vector<Vec3>& positions, std::uint32_t vertex, const Ring& ring) {
  const float weight = 1 / (float(ring.size()) + 3 / (8 * neighbor_weight(ring.size())));
  return mixed(positions, vertex, ring, weight, 1.0f / 6);
}

/// The vertex that halves an edge.
Vec3 middle(const std::vector<Vec3>& positions, const Surface& surface, std::size_t half_edge) {
  const Vec3 ends = positions[surface.from(half_edge)] + positions[surface.to(half_edge)];
  const std::uint32_t twin = surface.twin(half_edge);
  if (twin == no_half_edge) return ends * 0.5f;
  const Vec3 beside = positions[surface.opposite(half_edge)] + positions[surface.opposite(twin)];
  return ends * 0.375f + beside * 0.125f;
}

void divide(std::vector<Vec3>& positions, std::vector<Triangle>& triangles) {
  const Surface surface(triangles, positions.size());
  const auto old = std::uint32_t(positions.size());
  std::vector<Vec3> places(old + surface.edge_count());
  Ring ring;
  for (std::uint32_t vertex = 0; vertex < old; ++vertex) {
    surface.find_ring(vertex, ring);
    places[vertex] = ring.size() == 0 ? positions[vertex] : next_place(positions, vertex, ring);
  }
  std::vector<Triangle> quarters;
  quarters.reserve(4 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    Triangle middles;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t half = 3 * t + k;
      middles[k] = old + surface.edge(half);
      if (const std::uint32_t twin = surface.twin(half); twin == no_half_edge || half < twin)
        places[middles[k]] = middle(positions, surface, half);
    }
    const auto& [a, b, c] = triangles[t];
    const auto& [ab, bc, ca] = middles;
    for (const Triangle& quarter :
         {Triangle{a, ab, ca}, Triangle{ab, b, bc}, Triangle{ca, bc, c}, Triangle{ab, bc, ca}})
      quarters.push_back(quarter);
  }
  positions = std::move(places);
  triangles = std::move(quarters);
}

/// Two tangents of the limit surface, the second one counter-clockwise from the first.
struct LimitTangents {
  Vec3 first, second;
};

LimitTangents tangents_inside(const std::vector<Vec3>& positions, const Ring& ring) {
  LimitTangents found;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const double angle = 2 * pi_double * double(i) / double(ring.size());
    found.first += positions[ring[i]] * float(cos_radians(angle));
    found.second += positions[ring[i]] * float(sin_radians(angle));
  }
  return found;
}

/// Across the surface's end, into it: the left eigenvector of one division of a vertex and its n neighbours
/// whose eigenvalue is 3/8 + cos(a) / 4, a = pi / (n - 1). Neighbour i has the weight sin(i a), but for both
/// ends; all weights together are none. With eight neighbours or more the surface has a crease there, and
/// this is one side.
Vec3 tangent_across_end(const std::vector<Vec3>& positions, std::uint32_t vertex, const Ring& ring) {
  const Vec3& own = positions[vertex];
  const Vec3 ends = positions[ring[0]] + positions[ring.last()];
  if (ring.size() == 2) return ends - own * 2;
  const double angle = pi_double / double(ring.size() - 1);
  const double inner = cos_radians(angle / 2) / sin_radians(angle / 2);  // The sum of sin(i a).
  const double end = -cos_radians(angle) * inner / (1 + 2 * cos_radians(angle));
  Vec3 sum = ends * float(end) - own * float(inner + 2 * end);
  for (std::size_t i = 1; i + 1 < ring.size(); ++i)
    sum += positions[ring[i]] * float(sin_radians(double(i) * angle));
  return sum;
}

Vec3 limit_normal(const std::vector<Vec3>& positions, std::uint32_t vertex, const Ring& ring) {
  const LimitTangents tangents = ring.is_open ? LimitTangents{positions[ring[0]] - positions[ring.last()],
                                                              tangent_across_end(positions, vertex, ring)}
                                              : tangents_inside(positions, ring);
  const Vec3 normal = cross(tangents.first, tangents.second);
  return length_squared(normal) > 0 ? normalize(normal) : Vec3{};
}

/// Moves all vertices to the limit surface; returns its normals there, zero where it has none.
std::vector<Vec3> move_to_limit(std::vector<Vec3>& positions, const std::vector<Triangle>& triangles) {
  const Surface surface(triangles, positions.size());
  std::vector<Vec3> places = positions, normals(positions.size());
  Ring ring;
  for (std::uint32_t vertex = 0; vertex < positions.size(); ++vertex) {
    surface.find_ring(vertex, ring);
    if (ring.size() == 0) continue;
    places[vertex] = limit_place(positions, vertex, ring);
    normals[vertex] = limit_normal(positions, vertex, ring);
  }
  positions = std::move(places);
  return normals;
}

}  // namespace

std::optional<Mesh> loop_subdivided(const Mesh& control, int levels) {
  if (!Surface(control.triangles, control.positions.size()).is_surface()) return std::nullopt;
  Mesh mesh;
  mesh.name = control.name;
  mesh.is_opaque = control.is_opaque;
  mesh.positions = control.positions;
  mesh.triangles = control.triangles;
  for (int level = 0; level < levels; ++level) divide(mesh.positions, mesh.triangles);
  mesh.normals = move_to_limit(mesh.positions, mesh.triangles);
  mesh.normal_indices = mesh.triangles;
  return mesh;
}

}  // namespace twinray
