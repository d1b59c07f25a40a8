// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/medium.h"

#include <fmt/format.h>

#include <string_view>
#include <vector>

#include "io/pbrt/spectrum.h"

namespace twinray {
namespace {

/// Of a medium that says nothing, per millimeter, as pbrt has them.
constexpr Rgb default_absorption{0.0011f, 0.0024f, 0.014f}, default_scattering{2.55f, 3.21f, 3.77f};

Rgb read_homogeneous(const PbrtParameters& parameters, PbrtContext& context) {
  if (const PbrtParameter* preset = parameters.find("preset"))
    preset->place.warn(context.warnings, "measured media are not known here: this one is taken as clear");
  const bool is_measured = parameters.find("preset") != nullptr;
  parameters.find("g");
  const float scale = parameters.real("scale", 1, {0, 1e9});
  const Rgb absorption = scale * color_of(parameters, "sigma_a", is_measured ? Rgb{} : default_absorption,
                                          ColorRole::unbounded, context.files);
  const Rgb scattering = scale * color_of(parameters, "sigma_s", is_measured ? Rgb{} : default_scattering,
                                          ColorRole::unbounded, context.files);
  if (!is_finite(absorption)) parameters.place().fail("this medium absorbs more than a number can say");
  if (!is_black(scattering))
    parameters.place().warn(context.warnings,
                            "what this medium scatters is not rendered, only what it absorbs");
  if (!is_black(color_of(parameters, "Le", {}, ColorRole::light, context.files)))
    parameters.place().warn(context.warnings, "light of media is not rendered");
  parameters.find("Lescale");
  return absorption;
}

}  // namespace

void PbrtMedia::define(const std::string& name, const PbrtParameters& parameters) {
  const std::string type = parameters.text("type", "");
  if (type.empty()) parameters.place().fail("MakeNamedMedium needs the kind of medium, \"string type\"");
  std::shared_ptr<PbrtMedium>& medium = media_[name];
  if (!medium) medium = std::make_shared<PbrtMedium>();
  if (medium->absorption)
    parameters.place().fail(fmt::format("the medium \"{}\" is made a second time", name));
  if (type == "homogeneous") {
    medium->absorption = read_homogeneous(parameters, context_);
    return parameters.warn_of_unused(context_.warnings);
  }
  constexpr std::string_view uneven[] = {"uniformgrid", "rgbgrid", "cloud", "nanovdb"};
  for (const std::string_view each : uneven)
    if (type == each) {
      parameters.place().warn(context_.warnings,
                              fmt::format("a medium of the kind \"{}\" is not rendered: it is clear", type));
      medium->absorption = Rgb{};
      return;
    }
  parameters.place().fail(fmt::format(
      "there is no medium \"{}\"; valid are homogeneous, uniformgrid, rgbgrid, cloud and nanovdb", type));
}

PbrtMediumPointer PbrtMedia::named(const std::string& name, const PbrtPlace& place) {
  if (name.empty()) return nullptr;
  std::shared_ptr<PbrtMedium>& medium = media_[name];
  if (!medium) medium = std::make_shared<PbrtMedium>(PbrtMedium{{}, place});
  return medium;
}

void PbrtMedia::check_all_made() const {
  std::vector<std::string_view> made;
  for (const auto& [name, medium] : media_)
    if (medium->absorption) made.push_back(name);
  for (const auto& [name, medium] : media_) {
    if (medium->absorption) continue;
    const std::string nearest = nearest_name(name, made);
    medium->first_use.fail(
        fmt::format("no MakeNamedMedium makes \"{}\"{}", name,
                    nearest.empty() ? "" : fmt::format("; \"{}\" is the nearest one", nearest)));
  }
}

}  // namespace twinray
