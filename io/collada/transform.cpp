// SPDX-License-Identifier: Apache-2.0
#include "io/collada/transform.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "core/elementary.h"

namespace twinray {
namespace {

using Double3 = std::array<double, 3>;

double dot3(const Double3& a, const Double3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Double3 cross3(const Double3& a, const Double3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The unit vector; {0, 0, 0} where there is none.
Double3 unit(const Double3& a) {
  const double length = std::sqrt(dot3(a, a));
  return length > 0 ? Double3{a[0] / length, a[1] / length, a[2] / length} : Double3{};
}

bool is_zero(const Double3& a) { return a[0] == 0 && a[1] == 0 && a[2] == 0; }

/// Up to what programs lose when they multiply and write matrices.
bool is_last_row(double x, double y, double z, double w) {
  constexpr double tolerance = 1e-5;
  return std::fabs(x) <= tolerance && std::fabs(y) <= tolerance && std::fabs(z) <= tolerance &&
         std::fabs(w - 1) <= tolerance;
}

Transform read_rotate(const XmlElement& element) {
  const auto v = element.doubles(4);
  const Vec3 axis{float(v[0]), float(v[1]), float(v[2])};
  if (v[3] == 0) return {};
  if (!(max_abs(axis) > 0)) element.fail("the axis of <rotate> is 0 0 0; it needs a direction");
  return Transform::rotation(axis, v[3]);
}

/// The axis that is the farthest from a direction.
Double3 farthest_axis(const Double3& direction) {
  std::size_t least = 2;
  for (const std::size_t i : {1, 0})
    if (std::fabs(direction[i]) < std::fabs(direction[least])) least = i;
  Double3 axis{};
  axis[least] = 1;
  return axis;
}

/// Stands at the eye and looks along -z at the point of interest, with y towards the up direction.
Transform read_lookat(const XmlElement& element, ColladaDocument& document) {
  const auto v = element.doubles(9);
  const Double3 eye{v[0], v[1], v[2]};
  const Double3 back = unit({v[0] - v[3], v[1] - v[4], v[2] - v[5]});
  Double3 right = unit(cross3({v[6], v[7], v[8]}, back));
  if (is_zero(back)) element.fail("<lookat> stands where it looks at; the two points must differ");
  if (is_zero(right)) {
    document.warn(element, "the up direction of <lookat> is the direction it looks in; another one is taken");
    right = unit(cross3(farthest_axis(back), back));
  }
  const Double3 up = cross3(back, right);
  Transform result;
  for (std::size_t row = 0; row < 3; ++row) {
    result.m[row][0] = right[row];
    result.m[row][1] = up[row];
    result.m[row][2] = back[row];
    result.m[row][3] = eye[row];
  }
  return result;
}

/// Shifts points along b so that a turns by the angle towards b (the RenderMan Interface's Skew, to which
/// COLLADA refers). With a = A1 e + A2 b, e a unit vector perpendicular to b, a is to become A1 e + (A2 + s)
/// b at the angle phi + theta from e, tan phi = A2 / A1: s = A1 tan(phi + theta) - A2. A point x is shifted
/// by s (x.e) / A1.
Transform read_skew(const XmlElement& element) {
  const auto v = element.doubles(7);
  const Double3 a = unit({v[1], v[2], v[3]}), b = unit({v[4], v[5], v[6]});
  const double along = dot3(a, b);
  const Double3 across{a[0] - along * b[0], a[1] - along * b[1], a[2] - along * b[2]};
  const double a1 = std::sqrt(dot3(across, across));
  if (is_zero(a) || is_zero(b) || a1 < 1e-9)
    element.fail("the axes of <skew> must be two different directions");
  const double tan_phi = along / a1;
  const double tan_theta = tan_radians(std::fmod(v[0], 360.0) * 0.017453292519943295);
  const double denominator = 1 - tan_phi * tan_theta;
  if (!(std::fabs(v[0]) < 90) || denominator < 1e-9)
    throw error_at(element.number_place(0),
                   fmt::format("the angle of <skew> is {}; it must lie between -90 and 90 degrees, "
                               "and not reach the second axis",
                               v[0]));
  const double shift = (tan_phi + tan_theta) / denominator - tan_phi;
  Transform result;
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 3; ++column)
      result.m[row][column] += shift * b[row] * across[column] / a1;
  return result;
}

bool is_transform(const XmlElement& element) {
  for (const char* name : {"matrix", "rotate", "lookat", "skew", "translate", "scale"})
    if (element.is(name)) return true;
  return false;
}

}  // namespace

Transform read_matrix(const XmlElement& element, ColladaDocument& document) {
  std::vector<double> values = element.doubles();
  if (values.size() < 12 || values.size() > 16)
    element.fail(fmt::format("<{}> needs 16 numbers, row by row, and has {}", element.name(), values.size()));
  if (values.size() < 16)
    document.warn(element,
                  fmt::format("<{}> needs 16 numbers and has {}; the first 12 are used, and the last row is "
                              "taken to be 0 0 0 1",
                              element.name(), values.size()));
  else if (!is_last_row(values[12], values[13], values[14], values[15]))
    throw error_at(element.number_place(12),
                   fmt::format("the last row of <{}> must be 0 0 0 1", element.name()));
  Transform result;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column) result.m[row][column] = values[std::size_t(4 * row + column)];
  return result;
}

Transform read_node_transform(const XmlElement& node, ColladaDocument& document) {
  Transform result;
  for (const XmlElement& element : node.children()) {
    if (is_transform(element) && document.is_empty(element)) continue;
    if (element.is("matrix")) {
      result = result * read_matrix(element, document);
      if (document.options().interpretation == Interpretation::cs184) break;
    }
    if (element.is("rotate")) result = result * read_rotate(element);
    if (element.is("lookat")) result = result * read_lookat(element, document);
    if (element.is("skew")) result = result * read_skew(element);
    if (element.is("translate")) {
      const auto v = element.doubles(3);
      result = result * Transform::translation(v[0], v[1], v[2]);
    }
    if (element.is("scale")) {
      const auto v = element.doubles(3);
      result = result * Transform::scaling(v[0], v[1], v[2]);
    }
  }
  return result;
}

}  // namespace twinray
