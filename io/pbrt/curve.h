// SPDX-License-Identifier: Apache-2.0
// Curves, such as hair and grass, cut into triangles: tubes with smooth normals, and ribbons.
#pragma once
#include <cstddef>
#include <vector>

#include "core/geometry.h"

namespace twinray {

enum class CurveBasis { bezier, bspline };
enum class CurveKind {
  flat,      ///< Turned to each ray: a tube of four sides, whose mean width from all around is the curve's.
  cylinder,  ///< A tube of eight sides, likewise.
  ribbon     ///< Turned to normals.
};

/// As pbrt's "curve" has it: Bezier segments that share their ends, or a uniform B-spline.
struct Curve {
  CurveKind kind = CurveKind::flat;
  CurveBasis basis = CurveBasis::bezier;
  int degree = 3;                  ///< 2 or 3.
  std::vector<Vec3> points;        ///< As many as segments_of() takes.
  float width0 = 1, width1 = 1;    ///< At the beginning and the end: across all of it; >= 0.
  std::vector<Vec3> normals = {};  ///< Of a ribbon, one more than segments.
  bool has_ends = false;           ///< A tube is closed at its ends.
};

/// How many segments so many points make; 0 where they are no curve.
std::size_t segments_of(CurveBasis basis, int degree, std::size_t points);

/// Triangles whose texture coordinates run along the curve (u) and around or across it (v). A segment is cut
/// into steps that lie within a fiftieth of its width, or 0.004 of its control polygon's length, whichever is
/// more; 32 at most. The ends of tubes are open, unless the curve has ends.
Mesh curve_mesh(const Curve& curve);

}  // namespace twinray
