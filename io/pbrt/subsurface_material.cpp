// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/subsurface_material.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/phase_function.h"
#include "core/subsurface.h"
#include "io/pbrt/measured_media.h"

namespace twinray {
namespace {

/// None where no light goes any way below; else a thousandth of the longest way, at least.
Rgb radius_in_range(const Rgb& radius) {
  constexpr float most = 1e30f, least_part = 1e-3f;
  const float longest = std::min(max_component(radius), most);
  const auto channel = [&](float r) { return std::clamp(r, longest * least_part, most); };
  return longest > 1 / most ? Rgb{channel(radius.r), channel(radius.g), channel(radius.b)} : Rgb{};
}

float anisotropy(const PbrtMaterialInputs& in, const char* name) {
  constexpr float most = PhaseFunction::most_anisotropy;
  return std::clamp(in.parameters.real(name, 0, {-1, 1}), -most, most);
}

/// By what the body does to light on its way: sets the base's reflectance.
void set_by_coefficients(const Rgb& absorption, const Rgb& scattering, CoatedDiffuse& model,
                         Subsurface& below) {
  const auto channel = [&](float a, float s, float& reflectance, float& radius) {
    const float extinction = a + s;
    reflectance = s > 0 ? diffuse_reflectance(s / extinction, below.anisotropy) : 0;
    radius = 1 / extinction;
  };
  Rgb radius;
  channel(absorption.r, scattering.r, model.reflectance.r, radius.r);
  channel(absorption.g, scattering.g, model.reflectance.g, radius.g);
  channel(absorption.b, scattering.b, model.reflectance.b, radius.b);
  below.radius = radius_in_range(radius);
}

const MeasuredMedium& measured(const PbrtMaterialInputs& in, const std::string& name) {
  if (const MeasuredMedium* const known = measured_medium(name)) return *known;
  const std::string nearest = nearest_name(name, measured_media());
  in.parameters.find("name")->place.fail(
      fmt::format("there is no measured medium \"{}\"{}", name,
                  nearest.empty() ? "" : fmt::format("; \"{}\" is the nearest name", nearest)));
}

/// Two inputs that say the same thing in two ways.
void refuse_both(const PbrtMaterialInputs& in, const char* one, const char* other) {
  if (in.has(one) && in.has(other))
    in.parameters.find(other)->place.fail(
        fmt::format("a subsurface material has \"{}\" or \"{}\", not both", one, other));
}

}  // namespace

SurfaceModel read_subsurface(const PbrtMaterialInputs& in, Subsurface& below) {
  CoatedDiffuse model{.roughness = in.roughness(), .ior = in.has("eta") ? in.coat_ior("eta") : 1.33f};
  const float scale = in.parameters.real("scale", 1, {0, 1e9});
  const std::string name = in.parameters.text("name", "");
  below.anisotropy = anisotropy(in, "g");
  for (const char* other : {"sigma_a", "sigma_s", "reflectance"}) refuse_both(in, "name", other);
  for (const char* other : {"sigma_a", "sigma_s"}) refuse_both(in, "reflectance", other);
  if (in.has("sigma_a") != in.has("sigma_s"))
    in.parameters.find(in.has("sigma_a") ? "sigma_a" : "sigma_s")
        ->place.fail("a subsurface material needs both \"sigma_a\" and \"sigma_s\"");
  if (in.has("reflectance")) {
    const Rgb emerging = in.color("reflectance", {}, MaterialInput::reflectance, InputMeaning::emerging);
    model.reflectance = base_of_emerging(model, emerging);
    below.radius = radius_in_range(in.color("mfp", white, ColorRole::unbounded) * scale);
    return model;
  }
  if (in.has("mfp"))
    in.parameters.find("mfp")->place.warn(in.context.warnings,
                                          "without a \"reflectance\", \"mfp\" says nothing");
  if (!name.empty()) {
    const MeasuredMedium& medium = measured(in, name);
    set_by_coefficients(medium.absorption * scale, medium.scattering * scale, model, below);
  } else {
    // Where nothing is said it is pbrt's own: skin, per millimeter.
    const Rgb absorption = in.color("sigma_a", {0.0011f, 0.0024f, 0.014f}, ColorRole::unbounded);
    const Rgb scattering = in.color("sigma_s", {2.55f, 3.21f, 3.77f}, ColorRole::unbounded);
    set_by_coefficients(absorption * scale, scattering * scale, model, below);
  }
  return model;
}

Subsurface read_principled_subsurface(const PbrtMaterialInputs& in, const Principled& model) {
  const float radius = in.parameters.real("subsurface_radius", 1, {0, 1e9});
  const Rgb scale = in.color("subsurface_radius_scale", {1, 0.5f, 0.25f}, ColorRole::unbounded);
  const float g = anisotropy(in, "subsurface_scatter_anisotropy");
  const bool has_texture = std::any_of(in.uses.begin(), in.uses.end(), [](const TextureUse& use) {
    return use.input == MaterialInput::subsurface_weight;
  });
  if (model.subsurface_weight == 0 && !has_texture) return {};
  if (!model.geometry_thin_walled) return {radius_in_range(scale * radius), g};
  in.parameters.find("subsurface_weight")
      ->place.warn(in.context.warnings,
                   "light below a sheet is not rendered; a diffuse surface stands for it");
  return {};
}

}  // namespace twinray
