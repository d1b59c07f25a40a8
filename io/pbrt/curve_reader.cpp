// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/curve_reader.h"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "io/pbrt/mesh.h"
#include "io/pbrt/word.h"

namespace twinray {
namespace {

constexpr NumberRange widths{0, 1e12};

constexpr std::array<PbrtWord<CurveKind>, 3> kinds_of_curves{
    {{"flat", CurveKind::flat}, {"cylinder", CurveKind::cylinder}, {"ribbon", CurveKind::ribbon}}};
constexpr std::array<PbrtWord<CurveBasis>, 2> bases{
    {{"bezier", CurveBasis::bezier}, {"bspline", CurveBasis::bspline}}};

void check_points(const Curve& curve, const PbrtPlace& place) {
  if (segments_of(curve.basis, curve.degree, curve.points.size()) > 0) return;
  const std::string valid =
      curve.basis == CurveBasis::bspline
          ? fmt::format("{} or more", curve.degree + 1)
          : fmt::format("{}, and {} more for each further segment", curve.degree + 1, curve.degree);
  place.fail(fmt::format("a curve of {} points; valid are {}", curve.points.size(), valid));
}

}  // namespace

Curve read_curve_points(const PbrtParameters& parameters, WarningList& warnings) {
  Curve curve;
  curve.kind = word_of(parameters, "type", kinds_of_curves);
  curve.basis = word_of(parameters, "basis", bases);
  curve.degree = parameters.integer("degree", 3, {2, 3});
  curve.points = triples(parameters.tuples("P", 3));
  check_points(curve, parameters.place());
  const float width = parameters.real("width", 1, widths);
  curve.width0 = parameters.real("width0", width, widths);
  curve.width1 = parameters.real("width1", width, widths);
  std::vector<Vec3> normals = triples(parameters.tuples("N", 3));
  if (curve.kind != CurveKind::ribbon) {
    if (!normals.empty())
      parameters.find("N")->place.warn(warnings, "\"N\" has no effect: the curve is no ribbon");
    return curve;
  }
  const std::size_t count = segments_of(curve.basis, curve.degree, curve.points.size()) + 1;
  if (normals.size() != count)
    parameters.place().fail(fmt::format("a ribbon of {} segments needs {} normals, \"normal N\"; here are {}",
                                        count - 1, count, normals.size()));
  curve.normals = std::move(normals);
  return curve;
}

}  // namespace twinray
