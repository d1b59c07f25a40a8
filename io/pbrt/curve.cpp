// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/curve.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/angle.h"
#include "core/elementary.h"

namespace twinray {
namespace {

/// The four points of a cubic Bezier curve.
using Bezier = std::array<Vec3, 4>;

Vec3 lerp(const Vec3& a, const Vec3& b, float t) { return a * (1 - t) + b * t; }

Bezier elevated(const Vec3& a, const Vec3& b, const Vec3& c) {
  return {a, lerp(a, b, 2.0f / 3), lerp(c, b, 2.0f / 3), c};
}

/// A segment of a uniform B-spline, by its blossoms.
Bezier of_bspline(const Vec3* p, int degree) {
  if (degree == 2) return elevated(lerp(p[0], p[1], 0.5f), p[1], lerp(p[1], p[2], 0.5f));
  const Vec3 b = lerp(p[1], p[2], 1.0f / 3), c = lerp(p[1], p[2], 2.0f / 3);
  return {lerp(lerp(p[0], p[1], 2.0f / 3), b, 0.5f), b, c, lerp(c, lerp(p[2], p[3], 1.0f / 3), 0.5f)};
}

Bezier segment(const Curve& curve, std::size_t i) {
  const Vec3* const first = curve.points.data() + i * (curve.basis == CurveBasis::bezier ? curve.degree : 1);
  if (curve.basis == CurveBasis::bspline) return of_bspline(first, curve.degree);
  if (curve.degree == 2) return elevated(first[0], first[1], first[2]);
  return {first[0], first[1], first[2], first[3]};
}

/// De Casteljau's scheme: the point, and a vector along the curve that is 0 where it stands still.
struct CurvePlace {
  Vec3 point, along;
};
CurvePlace place_at(const Bezier& b, float t) {
  const Vec3 ab = lerp(b[0], b[1], t), bc = lerp(b[1], b[2], t), cd = lerp(b[2], b[3], t);
  const Vec3 abc = lerp(ab, bc, t), bcd = lerp(bc, cd, t);
  return {lerp(abc, bcd, t), bcd - abc};
}

/// A cubic differs from its chords by three quarters of its second differences over the square of their
/// number.
int steps_of(const Bezier& b, float width) {
  constexpr float most = 32, of_width = 0.02f, of_length = 0.004f;
  const float bend = std::max(length(b[0] - b[1] * 2 + b[2]), length(b[1] - b[2] * 2 + b[3]));
  const float outline = length(b[1] - b[0]) + length(b[2] - b[1]) + length(b[3] - b[2]);
  const float tolerance = std::max(of_width * width, of_length * outline);
  const float steps = std::sqrt(0.75f * bend / std::max(tolerance, 1e-30f));
  // Where numbers overflow there is no length: what is made of such points is refused later.
  return steps > 1 ? int(std::min(std::ceil(steps), most)) : 1;
}

/// Some unit vector perpendicular to a direction.
Vec3 perpendicular(const Vec3& d) {
  const Vec3 axis = std::fabs(d.x) < std::fabs(d.y) ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  return normalize(cross(d, axis));
}

/// A cross section of the curve.
struct Section {
  Vec3 center, along;  ///< `along` is a unit vector.
  float u, width;
  Vec3 normal = {};  ///< Of a ribbon.
};

std::vector<Section> sections_of(const Curve& curve) {
  const std::size_t count = segments_of(curve.basis, curve.degree, curve.points.size());
  std::vector<Section> sections;
  const auto add = [&](const Bezier& bezier, std::size_t i, float t) {
    CurvePlace place = place_at(bezier, t);
    if (!(length(place.along) > 0)) place.along = bezier[3] - bezier[0];
    if (!(length(place.along) > 0)) place.along = sections.empty() ? Vec3{0, 0, 1} : sections.back().along;
    const float u = (float(i) + t) / float(count);
    Section section{place.point, normalize(place.along), u, curve.width0 * (1 - u) + curve.width1 * u};
    if (!curve.normals.empty()) section.normal = lerp(curve.normals[i], curve.normals[i + 1], t);
    sections.push_back(section);
  };
  for (std::size_t i = 0; i < count; ++i) {
    const Bezier bezier = segment(curve, i);
    const int steps = steps_of(bezier, std::max(curve.width0, curve.width1));
    for (int step = i == 0 ? 0 : 1; step <= steps; ++step) add(bezier, i, float(step) / float(steps));
  }
  return sections;
}

/// Joins rings of so many corners each, one behind the other.
void join_rings(std::uint32_t corners, Mesh& mesh) {
  const auto rings = std::uint32_t(mesh.positions.size() / corners);
  for (std::uint32_t ring = 0; ring + 1 < rings; ++ring)
    for (std::uint32_t k = 0; k + 1 < corners; ++k) {
      const std::uint32_t a = ring * corners + k, b = a + 1, c = a + corners, d = c + 1;
      mesh.triangles.push_back({a, b, d});
      mesh.triangles.push_back({a, d, c});
    }
}

/// The first and the last corner of a ring lie in one place, but differ in v.
void add_ring(const Section& section, const Vec3& across, int sides, Mesh& mesh) {
  const Vec3 up = cross(section.along, across);
  // A convex outline is as wide, on the average over all directions, as a circle of its length.
  const float radius = 0.5f * section.width * pi / (float(sides) * sincos_turns(0.5f / float(sides)).sin);
  for (int k = 0; k <= sides; ++k) {
    const SinCos angle = sincos_turns(float(k % sides) / float(sides));
    const Vec3 normal = across * angle.cos + up * angle.sin;
    mesh.positions.push_back(section.center + normal * radius);
    mesh.normals.push_back(normal);
    mesh.uvs.push_back({section.u, float(k) / float(sides)});
  }
}

/// Closes a tube at its first or its last ring.
void add_end(const Section& section, std::uint32_t first, int sides, bool is_last, Mesh& mesh) {
  const auto begin = std::uint32_t(mesh.positions.size());
  for (std::uint32_t k = 0; k < std::uint32_t(sides); ++k) {
    mesh.positions.push_back(mesh.positions[first + k]);
    mesh.normals.push_back(is_last ? section.along : -section.along);
    mesh.uvs.push_back(mesh.uvs[first + k]);
    if (k < 2) continue;
    const std::uint32_t a = begin + k - 1, b = begin + k;
    mesh.triangles.push_back(is_last ? Triangle{begin, a, b} : Triangle{begin, b, a});
  }
}

Mesh tube(const std::vector<Section>& sections, int sides, bool has_ends) {
  Mesh mesh;
  Vec3 across = perpendicular(sections[0].along);
  for (const Section& section : sections) {
    // The direction across turns no more than the curve does.
    const Vec3 kept = across - section.along * dot(across, section.along);
    across = length(kept) > 1e-3f ? normalize(kept) : perpendicular(section.along);
    add_ring(section, across, sides, mesh);
  }
  const auto last = std::uint32_t(mesh.positions.size()) - std::uint32_t(sides) - 1;
  join_rings(std::uint32_t(sides) + 1, mesh);
  if (!has_ends) return mesh;
  add_end(sections.front(), 0, sides, false, mesh);
  add_end(sections.back(), last, sides, true, mesh);
  return mesh;
}

Mesh ribbon(const std::vector<Section>& sections) {
  Mesh mesh;
  for (const Section& section : sections) {
    const Vec3 side = cross(section.along, section.normal);
    const Vec3 across = length(side) > 0 ? normalize(side) : perpendicular(section.along);
    for (const float v : {0.0f, 1.0f}) {
      mesh.positions.push_back(section.center + across * ((v - 0.5f) * section.width));
      mesh.normals.push_back(cross(across, section.along));
      mesh.uvs.push_back({section.u, v});
    }
  }
  join_rings(2, mesh);
  return mesh;
}

}  // namespace

std::size_t segments_of(CurveBasis basis, int degree, std::size_t points) {
  const auto d = std::size_t(degree);
  if (points <= d) return 0;
  if (basis == CurveBasis::bspline) return points - d;
  return (points - 1) % d == 0 ? (points - 1) / d : 0;
}

Mesh curve_mesh(const Curve& curve) {
  const std::vector<Section> sections = sections_of(curve);
  Mesh mesh = curve.kind == CurveKind::ribbon
                  ? ribbon(sections)
                  : tube(sections, curve.kind == CurveKind::flat ? 4 : 8, curve.has_ends);
  mesh.normal_indices = mesh.uv_indices = mesh.triangles;
  return mesh;
}

}  // namespace twinray
