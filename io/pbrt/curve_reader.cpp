// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/curve_reader.h"

#include <fmt/format.h>

#include <string_view>
#include <utility>

#include "io/pbrt/mesh.h"

namespace twinray {
namespace {

constexpr NumberRange widths{0, 1e12};

/// One of some words; the first one where the parameter is missing.
template <typename Value, std::size_t n>
Value one_of(const PbrtParameters& parameters, const char* name,
             const std::pair<std::string_view, Value> (&words)[n]) {
  const std::string text = parameters.text(name, std::string(words[0].first));
  std::string known;
  for (const auto& [word, value] : words) {
    if (word == text) return value;
    known += fmt::format("{}{}", known.empty() ? "" : ", ", word);
  }
  parameters.find(name)->place.fail(
      fmt::format("there is no {} \"{}\" of curves; valid are {}", name, text, known));
}

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
  curve.kind = one_of<CurveKind>(
      parameters, "type",
      {{"flat", CurveKind::flat}, {"cylinder", CurveKind::cylinder}, {"ribbon", CurveKind::ribbon}});
  curve.basis = one_of<CurveBasis>(parameters, "basis",
                                   {{"bezier", CurveBasis::bezier}, {"bspline", CurveBasis::bspline}});
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
