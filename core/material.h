// SPDX-License-Identifier: Apache-2.0
// What a surface is made of, as a scene describes it: plain values. core/bsdf.h makes a scattering function
// of them.
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "core/rgb.h"

namespace twinray {

/// Width of the microfacets' distribution (GGX) along the tangent and the bitangent, each in [0, 1]; a smooth
/// surface has 0.
struct Roughness {
  float x = 0, y = 0;

  bool operator==(const Roughness&) const = default;
};

/// Reflects evenly in all directions, on both sides. Reflectance in [0, 1].
struct Lambert {
  Rgb reflectance{0.5f, 0.5f, 0.5f};
};

/// A perfect mirror, on both sides. Reflectance in [0, 1].
struct Mirror {
  Rgb reflectance{1, 1, 1};
};

/// CS184's smooth boundary that only refracts; where light cannot be refracted, it is reflected.
/// Transmittance in [0, 1]; ior is that of the inside to the outside, > 0. The roughness is read, and has no
/// effect.
struct Refraction {
  Rgb transmittance{1, 1, 1};
  float roughness = 0;
  float ior = 1.5f;
};

/// CS184's smooth dielectric boundary: reflects and refracts by Fresnel's equations, each in its colour. The
/// roughness is read, and has no effect.
struct Glass {
  Rgb transmittance{1, 1, 1};
  Rgb reflectance{1, 1, 1};
  float roughness = 0;
  float ior = 1.5f;
};

/// CS184's rough conductor: Beckmann facets of width alpha (> 0), complex index of refraction eta + i k per
/// channel.
struct Microfacet {
  float alpha = 0.5f;
  Rgb eta{0.2f, 0.9f, 1.1f};
  Rgb k{3.9f, 2.4f, 2.2f};
};

/// A boundary between two media that reflects and refracts by Fresnel's equations. ior is that of the inside
/// to the outside, > 0. A thin one is a sheet: both of its boundaries in one surface, so that light goes
/// straight on; it is smooth whatever its roughness.
struct Dielectric {
  float ior = 1.5f;
  Roughness roughness;
  Rgb reflectance{1, 1, 1}, transmittance{1, 1, 1};  ///< Factors, in [0, 1].
  bool is_thin = false;
};

/// A metal: complex index of refraction eta + i k per channel, and a factor in [0, 1].
struct Conductor {
  Rgb eta{0.2f, 0.9f, 1.1f};
  Rgb k{3.9f, 2.4f, 2.2f};
  Roughness roughness;
  Rgb reflectance{1, 1, 1};
};

/// Scatters evenly, to the side that the light comes from and to the other: each in [0, 1]. Where they sum up
/// to more than 1, all light is scattered, in their proportion.
struct DiffuseTransmission {
  Rgb reflectance{0.25f, 0.25f, 0.25f};
  Rgb transmittance{0.25f, 0.25f, 0.25f};
};

/// A rough diffuse surface (EON). The albedo of one event and the roughness are in [0, 1].
struct RoughDiffuse {
  Rgb reflectance{0.5f, 0.5f, 0.5f};
  float roughness = 0.5f;
};

/// A diffuse surface under a layer of a dielectric, such as varnish. ior is that of the coat to the outside.
struct CoatedDiffuse {
  Rgb reflectance{0.5f, 0.5f, 0.5f};
  Roughness roughness;
  float ior = 1.5f;
};

/// A metal under a layer of a dielectric. eta and k are the metal's to the vacuum.
struct CoatedConductor {
  Rgb eta{0.2f, 0.9f, 1.1f};
  Rgb k{3.9f, 2.4f, 2.2f};
  Roughness roughness;
  Rgb reflectance{1, 1, 1};  ///< A factor of the metal's, in [0, 1].
  Roughness coat_roughness;
  float coat_ior = 1.5f;
};

/// OpenPBR's surface, version 1.1, with its names, meanings and defaults (Andersson et al., "OpenPBR
/// Surface", Academy Software Foundation 2024), but for dispersion; its opacity is the shape's alpha, and
/// what is below it the material's Subsurface. Weights, colours and roughnesses lie in [0, 1]. Roughness is
/// the square root of alpha.
struct Principled {
  float base_weight = 1;
  Rgb base_color{0.8f, 0.8f, 0.8f};
  float base_diffuse_roughness = 0;
  float base_metalness = 0;
  float subsurface_weight = 0;  ///< Of what is diffuse and goes below the surface, if there is a Subsurface.
  Rgb subsurface_color{0.8f, 0.8f, 0.8f};
  float specular_weight = 1;
  Rgb specular_color{1, 1, 1};
  float specular_roughness = 0.3f;
  float specular_roughness_anisotropy = 0;
  float specular_ior = 1.5f;  ///< > 0.
  float transmission_weight = 0;
  Rgb transmission_color{1, 1, 1};
  float transmission_depth = 0;  ///< The way at which the colour is reached; 0: a tint of the surface. >= 0.
  float coat_weight = 0;
  Rgb coat_color{1, 1, 1};
  float coat_roughness = 0;
  float coat_ior = 1.6f;  ///< >= 1.
  float coat_darkening = 1;
  float fuzz_weight = 0;
  Rgb fuzz_color{1, 1, 1};
  float fuzz_roughness = 0.5f;
  float thin_film_weight = 0;        ///< Of a film on all of the base, below the coat (core/thin_film.h).
  float thin_film_thickness = 0.5f;  ///< In micrometers, >= 0.
  float thin_film_ior = 1.4f;        ///< >= 1.
  float emission_luminance = 0;      ///< Of its radiance, >= 0: io makes a light of it.
  Rgb emission_color{1, 1, 1};
  bool geometry_thin_walled = false;
};

/// A fibre of hair or fur, on tubes whose first texture coordinate runs along them (core/lobes/hair.h). Light
/// that goes into one leaves it at once: seen from within, its surface is not there.
struct Hair {
  /// The colour that many such fibres have together, components in (0, 1]: what they absorb follows from it.
  Rgb reflectance{0.5f, 0.27f, 0.1f};
  float longitudinal_roughness = 0.3f;  ///< In [0, 1]: beta_m,
  float azimuthal_roughness = 0.3f;     ///< and beta_n. Below least_hair_roughness they are that.
  float scale_tilt = 2;                 ///< Of the scales on its surface, in degrees.
  float ior = 1.55f;                    ///< >= 1.
};
inline constexpr float least_hair_roughness = 0.02f;

class MeasuredBrdf;

/// A material that was measured from all directions, on both sides (core/measured_brdf.h); never null.
struct Measured {
  std::shared_ptr<const MeasuredBrdf> brdf;
};

/// No surface at all: light goes straight on. Where an interior begins without a boundary that reflects.
struct Interface {};

/// One of two materials at each point, at random: the second with the probability `amount`, in [0, 1].
/// Indices into Scene::materials, of materials that stand before this one.
struct Mix {
  std::uint32_t first = 0, second = 0;
  float amount = 0.5f;
};

using SurfaceModel =
    std::variant<Lambert, Mirror, Refraction, Glass, Microfacet, Dielectric, Conductor, DiffuseTransmission,
                 RoughDiffuse, CoatedDiffuse, CoatedConductor, Principled, Hair, Measured, Interface, Mix>;

/// What of a model a texture may give, point by point: the member of that name. `reflectance` and `roughness`
/// are Principled's base_color and specular_roughness, too; `roughness_u` and `_v` are the axes of one.
/// Numbers take a texture's red.
enum class MaterialInput {
  reflectance,
  transmittance,
  roughness,
  roughness_u,
  roughness_v,
  coat_roughness,
  coat_roughness_u,
  coat_roughness_v,
  amount,
  eta,
  k,
  base_weight,
  base_diffuse_roughness,
  base_metalness,
  subsurface_weight,
  subsurface_color,
  specular_weight,
  specular_color,
  specular_roughness_anisotropy,
  transmission_weight,
  transmission_color,
  coat_weight,
  coat_color,
  coat_darkening,
  fuzz_weight,
  fuzz_color,
  fuzz_roughness,
  thin_film_weight,
  thin_film_thickness
};
/// The number of them.
inline constexpr int material_inputs = int(MaterialInput::thin_film_thickness) + 1;

/// What is made of a texture's value: itself; the roughness whose square it is, as pbrt has it; the k of a
/// metal of eta 1 that reflects so much of the light that falls straight on it; of Principled's anisotropy,
/// how much wider facets of its roughness are along the tangent, as glTF has it (widen()); of Principled's
/// fuzz_color, that colour times the weight, which is its brightest channel, as glTF has it (set_fuzz()); of
/// CoatedDiffuse's reflectance, the part that comes out again of light that has entered
/// (base_of_emerging()).
enum class InputMeaning { value, squared_roughness, metal_reflectance, widening, weighted_color, emerging };

/// The index of "no texture".
inline constexpr std::uint32_t no_texture = 0xffffffff;

struct TextureUse {
  MaterialInput input = MaterialInput::reflectance;
  std::uint32_t texture = 0;  ///< Index into Scene::textures.
  InputMeaning meaning = InputMeaning::value;
};

/// The index of "no density": a medium is the same everywhere.
inline constexpr std::uint32_t no_density = 0xffffffff;

/// What a medium emits: where it is as thick as can be, it looks so bright, since per unit of length it emits
/// its absorption times that.
struct Glow {
  Rgb radiance;  ///< >= 0.
  /// Index into Scene::densities: the radiance is times the number there,
  std::uint32_t factor = no_density;
  /// and, of another index, times the color of a black body (core/blackbody.h) as hot as the number there,
  /// less the offset, times the scale: kelvin.
  std::uint32_t temperature = no_density;
  float temperature_offset = 0, temperature_scale = 1;

  bool operator==(const Glow&) const = default;
  bool is_uneven() const { return factor != no_density || temperature != no_density; }
};

/// What lies within a closed surface that lets light in: a medium.
struct Interior {
  Rgb absorption;  ///< Per unit of length, >= 0: light that goes a way d is times e^(-absorption d).
  /// Where interiors overlap, the one of the highest priority is there; those of 0 do not hide others, nor
  /// are hidden. >= 0.
  std::int32_t priority = 0;
  bool is_clear = false;  ///< Nothing fills it, and what lies around it ends here: ice in tea.
  Rgb scattering;  ///< Per unit of length, >= 0: of light that goes a way d, e^(-scattering d) goes straight
                   ///< on.
  float anisotropy = 0;  ///< Of what is scattered: core/phase_function.h.
  /// Index into Scene::densities: the absorption and the scattering are times the density there.
  std::uint32_t density = no_density;
  Glow glow;

  bool operator==(const Interior&) const = default;
  /// Of light that goes a way d, the part e^(-extinction d) is neither absorbed nor scattered.
  Rgb extinction() const { return absorption + scattering; }
  /// What it emits per unit of length where its density and its glow's factors are 1.
  Rgb emission() const { return absorption * glow.radiance; }
  bool emits() const { return !is_black(emission()); }
};

/// Light below a surface: what the base of a CoatedDiffuse would reflect at once, or the subsurface's part of
/// a Principled's, enters the body behind it, is scattered there, and comes out elsewhere. Flat and large,
/// the body reflects as much as the base.
struct Subsurface {
  Rgb radius;            ///< The mean way between scatterings, per channel, > 0; black: there is none below.
  float anisotropy = 0;  ///< Of what is scattered: core/phase_function.h.

  bool operator==(const Subsurface&) const = default;
};

struct Material {
  std::string name;
  SurfaceModel model = Lambert{};
  std::vector<TextureUse> textures;  ///< In place of the model's own numbers; mostly none.
  Interior interior = {};
  Subsurface subsurface = {};             ///< Of a CoatedDiffuse or a Principled that is no sheet.
  std::uint32_t normal_map = no_texture;  ///< Textures that bend the shading normal (core/shading_map.h), if
  std::uint32_t bump_map = no_texture;    ///< any: by its own direction, or by a height in scene units.
  /// Of facets of unequal widths: where the tangent is, counter-clockwise from dp/du around the shading
  /// normal, in [-360, 360]; and a texture, if any, whose direction in that plane is turned so instead.
  float tangent_degrees = 0;
  std::uint32_t tangent_map = no_texture;
};

/// The texture that says an input of a material; null: none does.
const TextureUse* texture_use(const Material& material, MaterialInput input);
TextureUse* texture_use(Material& material, MaterialInput input);

/// Whether paths must know that they are within a surface of this material.
inline bool has_interior(const Material& material) { return material.interior != Interior{}; }
/// Whether light below a surface of this model is known of.
bool may_have_subsurface(const SurfaceModel& model);
/// Whether light is scattered below it.
inline bool has_subsurface(const Material& material) { return !is_black(material.subsurface.radius); }
/// Whether there is something within a closed surface of this model.
bool lets_light_in(const SurfaceModel& model);
/// The same, whatever its textures make of the model.
bool lets_light_in(const Material& material);

}  // namespace twinray
