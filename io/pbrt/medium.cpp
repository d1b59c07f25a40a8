// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/medium.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "core/aabb.h"
#include "core/phase_function.h"
#include "io/nanovdb/grid.h"
#include "io/pbrt/cloud.h"
#include "io/pbrt/measured_media.h"
#include "io/pbrt/spectrum.h"

namespace twinray {
namespace {

/// pbrt's preset, if one is named that there is.
const MeasuredMedium* preset_of(const PbrtParameters& parameters, PbrtContext& context) {
  const PbrtParameter* const named = parameters.find("preset");
  const std::string preset = parameters.text("preset", "");
  if (preset.empty()) return nullptr;
  const MeasuredMedium* const known = measured_medium(preset);
  if (!known) {
    const std::string nearest = nearest_name(preset, measured_media());
    named->place.warn(
        context.warnings,
        fmt::format("there is no measured medium \"{}\": its coefficients are those of the "
                    "statement{}",
                    preset, nearest.empty() ? "" : fmt::format("; \"{}\" is the nearest name", nearest)));
  }
  return known;
}

/// What a medium absorbs and scatters where its density is 1.
Interior read_coefficients(const PbrtParameters& parameters, const MeasuredMedium* preset,
                           PbrtContext& context) {
  const auto coefficient = [&](const char* name) {
    return color_of(parameters, name, {1, 1, 1}, ColorRole::unbounded, context.files);
  };
  const Rgb absorption = coefficient("sigma_a"), scattering = coefficient("sigma_s");
  const float scale = parameters.real("scale", 1, {0, 1e9});
  Interior interior{.absorption = scale * (preset ? preset->absorption : absorption),
                    .scattering = scale * (preset ? preset->scattering : scattering)};
  if (!is_finite(interior.extinction()))
    parameters.place().fail("this medium absorbs or scatters more than a number can say");
  // pbrt takes what is beyond as the nearest one, too.
  constexpr float most = PhaseFunction::most_anisotropy;
  interior.anisotropy = std::clamp(parameters.real("g", 0, {-1, 1}), -most, most);
  return interior;
}

Rgb read_radiance(const PbrtParameters& parameters, const PbrtContext& context) {
  return color_of(parameters, "Le", {}, ColorRole::light, context.files);
}

/// The box of a medium that ends by itself: corners of any order.
Aabb read_box(const PbrtParameters& parameters) {
  Aabb box;
  box.extend(parameters.point("p0", {0, 0, 0}));
  box.extend(parameters.point("p1", {1, 1, 1}));
  return box;
}

/// Takes the space of the scene to the one in which the box is [0, 1]^3.
Transform unit_of(const Aabb& box, const Transform& to_world) {
  const Vec3 &low = box.lower, extent = box.extent();
  return (to_world * Transform::translation(double(low.x), double(low.y), double(low.z)) *
          Transform::scaling(double(extent.x), double(extent.y), double(extent.z)))
      .inverse();
}

/// What `make` makes; where it throws Error, the place is that of the parameters.
template <typename Make>
auto made_at(const PbrtParameters& parameters, const Make& make) {
  try {
    return make();
  } catch (const Error& error) {
    parameters.place().fail(error.what());
  }
}

/// Of a uniformgrid's numbers of this name, if there are any.
std::shared_ptr<const DensityGrid> read_grid(const PbrtParameters& parameters, const char* name,
                                             const Transform& to_unit) {
  const std::span<const float> values = parameters.reals(name);
  if (values.empty()) return nullptr;
  const auto cells = [&](const char* along) {
    return parameters.integer(along, 1, {1, double(DensityGrid::most_cells)});
  };
  const DensityGrid::Size size{cells("nx"), cells("ny"), cells("nz")};
  try {
    const std::vector<float> numbers(values.begin(), values.end());
    return std::make_shared<const DensityGrid>(size, numbers, to_unit);
  } catch (const Error& error) {
    parameters.place().fail(fmt::format("\"{}\": {}", name, error.what()));
  }
}

/// What a number of a grid of temperatures means. Older files say "cutoff" for the offset.
void read_temperature_range(const PbrtParameters& parameters, Glow& glow) {
  const float cutoff = parameters.real("temperaturecutoff", 0);
  glow.temperature_offset = parameters.real("temperatureoffset", cutoff);
  glow.temperature_scale = parameters.real("temperaturescale", 1);
}

}  // namespace

std::uint32_t PbrtMedia::add(const std::shared_ptr<const DensityGrid>& grid) {
  if (!grid) return no_density;
  densities.push_back(grid);
  return std::uint32_t(densities.size() - 1);
}

Interior PbrtMedia::read_uniform_grid(const PbrtParameters& parameters, const Transform& to_world) {
  Interior filling = read_coefficients(parameters, nullptr, context_);
  const Transform to_unit = unit_of(read_box(parameters), to_world);
  filling.density = add(read_grid(parameters, "density", to_unit));
  if (filling.density == no_density)
    parameters.place().fail("a uniformgrid needs its numbers, \"float density\"");
  Glow& glow = filling.glow;
  glow.radiance = read_radiance(parameters, context_);
  glow.factor = add(read_grid(parameters, "Lescale", to_unit));
  glow.temperature = add(read_grid(parameters, "temperature", to_unit));
  read_temperature_range(parameters, glow);
  if (glow.temperature != no_density) {
    if (parameters.find("Le"))
      parameters.place().fail("a medium has either \"Le\" or \"temperature\", not both");
    glow.radiance = {1, 1, 1};
  }
  // pbrt's factor is a grid of one 1 then, which falls to an eighth in the corners of the box.
  if (filling.emits() && glow.factor == no_density)
    glow.factor =
        add(std::make_shared<const DensityGrid>(DensityGrid::Size{1, 1, 1}, std::vector{1.0f}, to_unit));
  return filling;
}

Interior PbrtMedia::read_cloud(const PbrtParameters& parameters, const Transform& to_world) {
  Interior filling = read_coefficients(parameters, nullptr, context_);
  constexpr NumberRange any_strength{0, 1e6};
  const PbrtCloud cloud{parameters.real("density", 1, any_strength),
                        parameters.real("wispiness", 1, any_strength),
                        parameters.real("frequency", 5, any_strength)};
  const Aabb box = read_box(parameters);
  filling.density = add(made_at(parameters, [&] {
    return std::make_shared<const DensityGrid>(cloud_grid(cloud, box, unit_of(box, to_world)));
  }));
  return filling;
}

std::shared_ptr<const DensityGrid> PbrtMedia::read_nvdb(const PbrtParameters& parameters,
                                                        const NvdbFile& file, const std::string& name,
                                                        const Transform& to_world) {
  const NvdbGrid grid = made_at(parameters, [&] { return read_nvdb_grid(file, name, to_world); });
  if (grid.negative > 0)
    parameters.place().warn(context_.warnings,
                            fmt::format("{} of the numbers of \"{}\" in {} are below 0: 0 stands for them",
                                        grid.negative, name, file.name()));
  return grid.densities;
}

Interior PbrtMedia::read_nanovdb(const PbrtParameters& parameters, const Transform& to_world) {
  Interior filling = read_coefficients(parameters, nullptr, context_);
  const PbrtParameter* const named = parameters.find("filename");
  const std::string name = parameters.text("filename", "");
  if (name.empty()) parameters.place().fail("a nanovdb medium needs its file, \"string filename\"");
  const std::string path = context_.files.path(named->place, name),
                    bytes = context_.files.bytes(named->place, path);
  const NvdbFile file = made_at(parameters, [&] { return NvdbFile(bytes, path); });
  const std::string density = parameters.text("gridname", "density"),
                    temperature = parameters.text("temperaturename", "temperature");
  filling.density = add(read_nvdb(parameters, file, density, to_world));
  read_temperature_range(parameters, filling.glow);
  const float strength = parameters.real("Lescale", 1, {0, 1e30});
  if (!file.has(temperature)) {
    if (parameters.find("temperaturename"))
      parameters.place().warn(
          context_.warnings,
          fmt::format("{} has no grid \"{}\": this medium emits no light", path, temperature));
    return filling;
  }
  filling.glow.radiance = {strength, strength, strength};
  filling.glow.temperature = add(read_nvdb(parameters, file, temperature, to_world));
  return filling;
}

void PbrtMedia::define(const std::string& name, const PbrtParameters& parameters, const Transform& to_world) {
  const std::string type = parameters.text("type", "");
  if (type.empty()) parameters.place().fail("MakeNamedMedium needs the kind of medium, \"string type\"");
  std::shared_ptr<PbrtMedium>& medium = media_[name];
  if (!medium) medium = std::make_shared<PbrtMedium>();
  if (medium->filling) parameters.place().fail(fmt::format("the medium \"{}\" is made a second time", name));
  if (type == "homogeneous") {
    medium->filling = read_coefficients(parameters, preset_of(parameters, context_), context_);
    medium->filling->glow.radiance =
        parameters.real("Lescale", 1, {0, 1e30}) * read_radiance(parameters, context_);
  } else if (type == "uniformgrid") {
    medium->filling = read_uniform_grid(parameters, to_world);
  } else if (type == "cloud") {
    medium->filling = read_cloud(parameters, to_world);
  } else if (type == "nanovdb") {
    medium->filling = read_nanovdb(parameters, to_world);
  } else if (type == "rgbgrid") {
    parameters.place().warn(context_.warnings,
                            fmt::format("a medium of the kind \"{}\" is not rendered: it is clear", type));
    medium->filling = Interior{};
    return;
  } else {
    parameters.place().fail(fmt::format(
        "there is no medium \"{}\"; valid are homogeneous, uniformgrid, rgbgrid, cloud and nanovdb", type));
  }
  if (!is_finite(medium->filling->emission()))
    parameters.place().fail("this medium emits more light than a number can say");
  parameters.warn_of_unused(context_.warnings);
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
    if (medium->filling) made.push_back(name);
  for (const auto& [name, medium] : media_) {
    if (medium->filling) continue;
    const std::string nearest = nearest_name(name, made);
    medium->first_use.fail(
        fmt::format("no MakeNamedMedium makes \"{}\"{}", name,
                    nearest.empty() ? "" : fmt::format("; \"{}\" is the nearest one", nearest)));
  }
}

}  // namespace twinray
