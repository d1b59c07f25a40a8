// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/material.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string_view>

#include "core/elementary.h"
#include "core/lobes/hair.h"
#include "core/measured_brdf.h"
#include "core/microfacet.h"
#include "core/nested_mixes.h"
#include "core/phase_function.h"
#include "core/radiance.h"
#include "core/textured_material.h"
#include "io/measured/brdf_file.h"
#include "io/pbrt/material_inputs.h"
#include "io/pbrt/spectrum.h"
#include "io/pbrt/subsurface_material.h"
#include "io/pbrt/version_three.h"

namespace twinray {
namespace {

constexpr Rgb half_grey{0.5f, 0.5f, 0.5f}, quarter_grey{0.25f, 0.25f, 0.25f};

SurfaceModel read_diffuse(const PbrtMaterialInputs& in) {
  return Lambert{in.color("reflectance", half_grey)};
}

struct Metal {
  Rgb eta, k;
};

/// Copper where nothing is said.
Metal read_metal(const PbrtMaterialInputs& in, const std::string& prefix) {
  const std::string eta = prefix + "eta", k = prefix + "k";
  if (in.has("reflectance")) {
    if (in.has(eta) || in.has(k))
      in.parameters.find("reflectance")
          ->place.fail("a metal has \"reflectance\" or \"eta\" and \"k\", not both");
    return {{1, 1, 1}, in.k_of_reflectance(*in.parameters.find("reflectance"))};
  }
  return {in.color(eta.c_str(), named_spectrum("metal-Cu-eta")->color, ColorRole::unbounded),
          in.color(k.c_str(), named_spectrum("metal-Cu-k")->color, ColorRole::unbounded)};
}

SurfaceModel read_conductor(const PbrtMaterialInputs& in) {
  const Metal metal = read_metal(in, "");
  return Conductor{metal.eta, metal.k, in.roughness()};
}

SurfaceModel read_dielectric(const PbrtMaterialInputs& in) {
  return Dielectric{in.ior("eta"), in.roughness()};
}

SurfaceModel read_thin(const PbrtMaterialInputs& in) {
  Dielectric sheet{in.ior("eta")};
  sheet.is_thin = true;
  return sheet;
}

/// What lies between the layers of a coated material, and how pbrt follows light there. How far our closed
/// form is from pbrt's usual way is known (docs/materials.md).
void read_between(const PbrtMaterialInputs& in) {
  for (const char* known : {"g", "nsamples"}) in.parameters.find(known);
  const auto warn = [&](const char* name, const char* reason) {
    in.parameters.find(name)->place.warn(in.context.warnings, reason);
  };
  if (!is_black(in.color("albedo", {}))) warn("albedo", "what scatters between the layers is not rendered");
  constexpr float usual_thickness = 0.01f;
  if (in.number("thickness", usual_thickness) > usual_thickness)
    warn("thickness", "what pbrt's coats absorb by their thickness is not rendered");
  constexpr int usual_depth = 10;
  if (in.parameters.integer("maxdepth", usual_depth, {0, 1e9}) < usual_depth)
    warn("maxdepth", "light between the layers is followed to its end");
}

SurfaceModel read_coated_diffuse(const PbrtMaterialInputs& in) {
  read_between(in);
  return CoatedDiffuse{in.color("reflectance", half_grey), in.roughness(), in.coat_ior("eta")};
}

SurfaceModel read_coated_conductor(const PbrtMaterialInputs& in) {
  read_between(in);
  const Metal metal = read_metal(in, "conductor.");
  CoatedConductor coated{metal.eta, metal.k, in.roughness("conductor.")};
  coated.coat_roughness = in.roughness("interface.", MaterialInput::coat_roughness);
  coated.coat_ior = in.coat_ior("interface.eta");
  return coated;
}

SurfaceModel read_transmission(const PbrtMaterialInputs& in) {
  const float scale = in.parameters.real("scale", 1, {0, 1e6});
  const DiffuseTransmission sheet{within_unit(in.color("reflectance", quarter_grey) * scale),
                                  within_unit(in.color("transmittance", quarter_grey) * scale)};
  if (scale != 1)
    for (TextureUse& use : in.uses) use.texture = in.textures.scaled(use.texture, scale);
  const float most = max_component(sheet.reflectance + sheet.transmittance);
  if (most > 1)
    in.parameters.place().warn(
        in.context.warnings,
        fmt::format("this surface would scatter {:g} of the light; it scatters all of it", most));
  return sheet;
}

struct PrincipledWeight {
  const char* name;
  float Principled::*member;
  float most = 1;
};
constexpr PrincipledWeight principled_weights[] = {
    {"base_weight", &Principled::base_weight},
    {"base_diffuse_roughness", &Principled::base_diffuse_roughness},
    {"base_metalness", &Principled::base_metalness},
    {"subsurface_weight", &Principled::subsurface_weight},
    {"specular_weight", &Principled::specular_weight},
    {"specular_roughness", &Principled::specular_roughness},
    {"specular_roughness_anisotropy", &Principled::specular_roughness_anisotropy},
    {"transmission_weight", &Principled::transmission_weight},
    {"transmission_depth", &Principled::transmission_depth, 1e9f},
    {"coat_weight", &Principled::coat_weight},
    {"coat_roughness", &Principled::coat_roughness},
    {"coat_darkening", &Principled::coat_darkening},
    {"fuzz_weight", &Principled::fuzz_weight},
    {"fuzz_roughness", &Principled::fuzz_roughness},
    {"thin_film_weight", &Principled::thin_film_weight},
    {"thin_film_thickness", &Principled::thin_film_thickness, 1000},
    // Blue light of this luminance is as bright as a picture can hold.
    {"emission_luminance", &Principled::emission_luminance, 0.0722f * max_radiance}};

struct PrincipledColor {
  const char* name;
  Rgb Principled::*member;
};
constexpr PrincipledColor principled_colors[] = {
    {"base_color", &Principled::base_color},         {"subsurface_color", &Principled::subsurface_color},
    {"specular_color", &Principled::specular_color}, {"transmission_color", &Principled::transmission_color},
    {"coat_color", &Principled::coat_color},         {"fuzz_color", &Principled::fuzz_color},
    {"emission_color", &Principled::emission_color}};

/// OpenPBR's surface: not one of pbrt's materials.
SurfaceModel read_principled(const PbrtMaterialInputs& in) {
  Principled model;
  for (const auto& [name, member, most] : principled_weights) {
    model.*member = in.number(name, model.*member);
    if (!(model.*member >= 0 && model.*member <= most))
      in.parameters.find(name)->place.fail(
          fmt::format("\"{}\" is {:g}; it lies in [0, {:g}]", name, model.*member, most));
  }
  for (const auto& [name, member] : principled_colors) model.*member = in.color(name, model.*member);
  if (in.has("specular_ior")) model.specular_ior = in.ior("specular_ior");
  for (const auto& [name, member] : {std::pair("coat_ior", &Principled::coat_ior),
                                     std::pair("thin_film_ior", &Principled::thin_film_ior)}) {
    if (!in.has(name)) continue;
    model.*member = in.ior(name);
    if (!(model.*member >= 1 && model.*member <= 100))
      in.parameters.find(name)->place.fail(
          fmt::format("\"{}\" is {:g}; it lies in [1, 100]", name, model.*member));
  }
  model.geometry_thin_walled = in.parameters.flag("geometry_thin_walled", false);
  return model;
}

/// What a clear surface of a colour and a depth absorbs and scatters within. Where more is scattered than the
/// colour says to be lost, all channels absorb more, so that none absorbs less than nothing: as OpenPBR has
/// it.
Interior filling_within(const Principled& model, const PbrtMaterialInputs& in) {
  constexpr float least = 1e-4f, least_depth = 1e-30f, most = PhaseFunction::most_anisotropy;
  const Rgb scatter = in.color("transmission_scatter", {}), color = model.transmission_color;
  const float anisotropy = in.parameters.real("transmission_scatter_anisotropy", 0, {-1, 1});
  if (model.transmission_depth < least_depth) return {};
  const auto channel = [&](float c) { return std::max(0.0f, -log_of(std::max(c, least))); };
  const Rgb lost = Rgb{channel(color.r), channel(color.g), channel(color.b)} - scatter;
  const float short_of = std::max(0.0f, -std::min({lost.r, lost.g, lost.b}));
  return {.absorption = (lost + Rgb{short_of, short_of, short_of}) / model.transmission_depth,
          .scattering = scatter / model.transmission_depth,
          .anisotropy = std::clamp(anisotropy, -most, most)};
}

/// Which parameter says the colour of fibres, but for pigments; null where none does. As in pbrt, the first
/// of these counts, and the others have no effect.
const char* color_of_hair(const PbrtMaterialInputs& in) {
  const char* said = nullptr;
  for (const char* name : {"sigma_a", "reflectance", "color", "eumelanin", "pheomelanin"}) {
    const PbrtParameter* const found = in.parameters.find(name);
    const std::string_view pigments = "melanin";
    const bool is_pigment = std::string_view(name).ends_with(pigments);
    if (found && said)
      found->place.warn(in.context.warnings,
                        fmt::format("\"{}\" has no effect: \"{}\" says the colour", name, said));
    else if (found && !is_pigment)
      said = name;
  }
  return said;
}

/// What fibres absorb, by their pigments, as pbrt has it.
Rgb pigments_of(const PbrtMaterialInputs& in) {
  const bool has_pigments = in.has("eumelanin") || in.has("pheomelanin");
  return Rgb{0.419f, 0.697f, 1.37f} * in.mean_number("eumelanin", has_pigments ? 0 : 1.3f, {0, 1e6}) +
         Rgb{0.187f, 0.4f, 1.05f} * in.mean_number("pheomelanin", 0, {0, 1e6});
}

SurfaceModel read_hair(const PbrtMaterialInputs& in) {
  Hair hair;
  hair.longitudinal_roughness = in.mean_number("beta_m", hair.longitudinal_roughness, {0, 1});
  hair.azimuthal_roughness = in.mean_number("beta_n", hair.azimuthal_roughness, {0, 1});
  hair.scale_tilt = in.mean_number("alpha", hair.scale_tilt, {-45, 45});
  hair.ior = in.mean_number("eta", hair.ior, {1, 100});
  const auto of = [&](const Rgb& absorption) {
    return hair_reflectance(absorption, hair.azimuthal_roughness);
  };
  const char* const said = color_of_hair(in);
  if (!said)
    hair.reflectance = of(pigments_of(in));
  else if (std::string_view(said) == "sigma_a")
    hair.reflectance = of(in.color(said, {}, ColorRole::unbounded));
  else
    hair.reflectance = in.color(said, {}, MaterialInput::reflectance, InputMeaning::value);
  return hair;
}

SurfaceModel read_measured(const PbrtMaterialInputs& in) {
  const std::string name = in.parameters.text("filename", "");
  if (name.empty()) in.parameters.place().fail("a measured material needs its file, \"string filename\"");
  const PbrtPlace& place = in.parameters.find("filename")->place;
  const std::string path = in.context.files.path(place, name);
  std::shared_ptr<const MeasuredBrdf>& known = in.context.brdfs[path];
  if (known) return Measured{known};
  try {
    known = std::make_shared<const MeasuredBrdf>(read_brdf_file(in.context.files.bytes(place, path), path));
  } catch (const Error& error) {
    place.fail(error.what());
  }
  return Measured{known};
}

struct MaterialReader {
  std::string_view type;
  SurfaceModel (*read)(const PbrtMaterialInputs&);
};
constexpr std::array<MaterialReader, 10> material_readers{{{"diffuse", read_diffuse},
                                                           {"conductor", read_conductor},
                                                           {"dielectric", read_dielectric},
                                                           {"thindielectric", read_thin},
                                                           {"coateddiffuse", read_coated_diffuse},
                                                           {"coatedconductor", read_coated_conductor},
                                                           {"diffusetransmission", read_transmission},
                                                           {"openpbr", read_principled},
                                                           {"hair", read_hair},
                                                           {"measured", read_measured}}};

SurfaceModel read_model(const std::string& type, const PbrtMaterialInputs& in) {
  const auto reader = std::find_if(material_readers.begin(), material_readers.end(),
                                   [&](const MaterialReader& r) { return r.type == type; });
  if (reader != material_readers.end()) return reader->read(in);
  std::vector<std::string_view> names;
  for (const MaterialReader& each : material_readers) names.push_back(each.type);
  for (const char* name : {"subsurface", "mix", "interface"}) names.push_back(name);
  in.parameters.place().fail(fmt::format("there is no material \"{}\"; valid are {}{}", type,
                                         list_names(names), version_three_hint(type)));
}

}  // namespace

PbrtMaterials::PbrtMaterials(PbrtContext& context) : textures(context), context_(context) {
  new_entry("default", {});
}

std::uint32_t PbrtMaterials::new_entry(const std::string& name, const Entry& entry) {
  materials.push_back({name});
  entries_.push_back(entry);
  return std::uint32_t(materials.size() - 1);
}

std::uint32_t PbrtMaterials::add(const std::string& type, const PbrtParameters& parameters) {
  const std::uint32_t index = new_entry(fmt::format("{}, line {}", type, parameters.place().line), {});
  make(index, type, parameters);
  return index;
}

void PbrtMaterials::add_named(const std::string& name, const PbrtParameters& parameters) {
  const auto known = named_.find(name);
  if (known != named_.end() && entries_[known->second].is_made)
    parameters.place().fail(fmt::format("the material \"{}\" is made a second time", name));
  const std::string type = parameters.text("type", "");
  if (type.empty()) parameters.place().fail("MakeNamedMaterial needs the kind of material, \"string type\"");
  const std::uint32_t index = known != named_.end() ? known->second : new_entry(name, {});
  named_[name] = index;
  entries_[index].is_made = true;
  make(index, type, parameters);
}

std::uint32_t PbrtMaterials::named(const std::string& name, const PbrtPlace& place) {
  const auto known = named_.find(name);
  if (known != named_.end()) return known->second;
  return named_[name] = new_entry(name, {false, false, place});
}

void PbrtMaterials::check_all_made() const {
  std::vector<std::string_view> made;
  for (const auto& [name, index] : named_)
    if (entries_[index].is_made) made.push_back(name);
  for (const auto& [name, index] : named_) {
    if (entries_[index].is_made) continue;
    const std::string nearest = nearest_name(name, made);
    entries_[index].first_use.fail(
        fmt::format("no MakeNamedMaterial makes \"{}\"{}", name,
                    nearest.empty() ? "" : fmt::format("; \"{}\" is the nearest one", nearest)));
  }
}

void PbrtMaterials::make(std::uint32_t index, const std::string& type, const PbrtParameters& parameters) {
  std::vector<TextureUse> uses;
  const PbrtMaterialInputs in{parameters, textures, context_, uses};
  if (type == "interface" || type == "none" || type.empty())
    entries_[index].is_interface = true, materials[index].model = Interface{};
  else if (type == "mix")
    materials[index].model = read_mix(index, in.number("amount", 0.5f), parameters);
  else if (type == "subsurface")
    materials[index].model = read_subsurface(in, materials[index].subsurface);
  else
    materials[index].model = read_model(type, in);
  if (const auto* const principled = std::get_if<Principled>(&materials[index].model))
    materials[index].subsurface = read_principled_subsurface(in, *principled);
  materials[index].textures = std::move(uses);
  if (lets_light_in(materials[index])) {
    if (const auto* model = std::get_if<Principled>(&materials[index].model))
      materials[index].interior = filling_within(*model, in);
    materials[index].interior.priority = parameters.integer("priority", 0, {0, 1e6});
  }
  materials[index].normal_map = textures.normal_map(parameters);
  materials[index].bump_map = textures.bump_map(parameters);
  parameters.warn_of_unused(context_.warnings);
}

Mix PbrtMaterials::read_mix(std::uint32_t index, float amount, const PbrtParameters& parameters) {
  const std::span<const std::string> names = parameters.texts("materials");
  if (names.size() != 2) parameters.place().fail("a mix needs two names in \"string materials\"");
  std::array<std::uint32_t, 2> indices{};
  for (std::size_t i = 0; i < 2; ++i) {
    const auto known = named_.find(names[i]);
    if (known == named_.end() || !entries_[known->second].is_made || known->second >= index)
      parameters.find("materials")
          ->place.fail(fmt::format("a mix is of materials that are made before it; \"{}\" is not", names[i]));
    if (is_interface(known->second))
      parameters.find("materials")
          ->place.fail(fmt::format("\"{}\" is an interface, which cannot be mixed", names[i]));
    indices[i] = known->second;
    int& mixes = entries_[index].mixes;
    mixes = std::max(mixes, 1 + entries_[known->second].mixes);
    if (mixes > most_nested_mixes)
      parameters.find("materials")
          ->place.fail(fmt::format("mixes may be in each other up to {} deep", most_nested_mixes));
  }
  return {indices[0], indices[1], std::clamp(amount, 0.0f, 1.0f)};
}

}  // namespace twinray
