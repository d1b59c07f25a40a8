// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/lens_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "io/pbrt/lexer.h"

namespace twinray {
namespace {

/// Lens files are in millimeters, the camera's space in meters.
constexpr double meter = 1000;

/// What `make` makes, in millimeters; where it throws Error, this place is named.
template <typename Make>
auto failing_at(const PbrtPlace& place, const Make& make) {
  try {
    return make();
  } catch (const Error& error) {
    place.fail(fmt::format("{} (in millimeters)", error.what()));
  }
}

/// A line for each surface: its curvature radius, thickness, index of refraction and aperture's diameter.
std::vector<LensSurface> parse_lens(const PbrtFile& file) {
  constexpr std::size_t columns = 4;
  std::vector<double> numbers;
  PbrtLexer lexer(file);
  while (lexer.next().kind != PbrtToken::Kind::end) {
    if (numbers.size() >= columns * LensSystem::most_surfaces)
      lexer.next().place.fail(fmt::format("a lens has up to {} surfaces", LensSystem::most_surfaces));
    numbers.push_back(lexer.take().precise());
  }
  if (numbers.empty() || numbers.size() % columns != 0)
    PbrtPlace{&file}.fail(fmt::format(
        "a lens file of {} numbers; each surface needs four: curvature radius, thickness, index of "
        "refraction and aperture diameter",
        numbers.size()));
  std::vector<LensSurface> surfaces;
  for (std::size_t i = 0; i < numbers.size(); i += columns)
    surfaces.push_back({numbers[i], numbers[i + 1], numbers[i + 2], numbers[i + 3] / 2});
  return surfaces;
}

/// No wider than the file has it.
void set_stop(const PbrtParameters& parameters, std::vector<LensSurface>& surfaces, WarningList& warnings) {
  const auto diameter = double(parameters.real("aperturediameter", 1, {0.01, 1e6}));
  bool has_stop = false;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    LensSurface& surface = surfaces[i];
    if (!is_stop(surfaces, i)) {
      if (surface.curvature_radius == 0)
        parameters.place().warn(
            warnings, fmt::format("surface {} of this lens is flat and divides glass from something "
                                  "else: it refracts here, and is a stop in pbrt",
                                  i + 1));
      continue;
    }
    has_stop = true;
    if (float(diameter / 2) > float(surface.aperture_radius))
      parameters.place().warn(
          warnings, fmt::format("an aperture of {:g} mm is wider than this lens allows: it is {:g} mm",
                                diameter, 2 * surface.aperture_radius));
    surface.aperture_radius = std::min(surface.aperture_radius, diameter / 2);
  }
  const PbrtParameter* const given = parameters.find("aperturediameter");
  if (given && !has_stop)
    given->place.warn(warnings, "this lens has no stop: \"aperturediameter\" changes nothing");
}

}  // namespace

std::vector<LensSurface> read_lens(const PbrtParameters& parameters, PbrtContext& context) {
  const PbrtParameter* const named = parameters.find("lensfile");
  const std::string name = parameters.text("lensfile", "");
  if (name.empty()) parameters.place().fail("a realistic camera needs its lens, \"string lensfile\"");
  const std::string path = context.files.path(named->place, name);
  const PbrtFile file{path, context.files.bytes(named->place, path)};
  std::vector<LensSurface> surfaces = parse_lens(file);
  failing_at(PbrtPlace{&file}, [&] { cardinal_points(surfaces); });
  set_stop(parameters, surfaces, context.warnings);
  if (const std::string shape = parameters.text("aperture", "circular");
      !shape.empty() && shape != "circular")
    parameters.find("aperture")
        ->place.warn(context.warnings,
                     fmt::format("an aperture of the shape \"{}\" is not rendered: it is round", shape));
  const auto focus = double(parameters.real("focusdistance", 10, {1e-6, 1e12}));
  return failing_at(parameters.place(), [&] { return focused(std::move(surfaces), focus * meter); });
}

LensSystem scaled_lens(std::vector<LensSurface> surfaces, double film_radius, double scale) {
  for (LensSurface& surface : surfaces)
    for (double LensSurface::*length :
         {&LensSurface::curvature_radius, &LensSurface::thickness, &LensSurface::aperture_radius})
      surface.*length *= scale;
  return LensSystem(std::move(surfaces), film_radius * scale);
}

}  // namespace twinray
