// SPDX-License-Identifier: Apache-2.0
// Private: what the exchange form says of textures, materials and lights, in its order. Each is described
// once, for the writer and the reader: members(visit, x) calls visit(key, member, valid) for what is a number
// or a colour, and visit(key, member) for the rest.
#pragma once
#include "core/light.h"
#include "core/material.h"
#include "core/pixel_filter.h"
#include "core/texture.h"

namespace twinray {

/// The numbers that a member may have; those of colours, each of the three. All are finite.
enum class Valid { any, not_negative, positive, at_least_one, part, film_thickness, film_ior, anisotropy };

// The types of textures,
inline const char* type_name(const ConstantTexture&) { return "constant"; }
inline const char* type_name(const ImageTexture&) { return "image"; }
inline const char* type_name(const ScaleTexture&) { return "scale"; }
inline const char* type_name(const MixTexture&) { return "mix"; }
inline const char* type_name(const CheckerboardTexture&) { return "checkerboard"; }
inline const char* type_name(const CubesTexture&) { return "cubes"; }
inline const char* type_name(const DotsTexture&) { return "dots"; }
inline const char* type_name(const BilinearTexture&) { return "bilinear"; }
inline const char* type_name(const DirectionMixTexture&) { return "direction_mix"; }
inline const char* type_name(const NoiseTexture&) { return "noise"; }
inline const char* type_name(const PlacedTexture&) { return "placed"; }
// of materials,
inline const char* type_name(const Lambert&) { return "lambert"; }
inline const char* type_name(const Mirror&) { return "mirror"; }
inline const char* type_name(const Refraction&) { return "refraction"; }
inline const char* type_name(const Glass&) { return "glass"; }
inline const char* type_name(const Microfacet&) { return "microfacet"; }
inline const char* type_name(const Dielectric& m) { return m.is_thin ? "thin_dielectric" : "dielectric"; }
inline const char* type_name(const Conductor&) { return "conductor"; }
inline const char* type_name(const DiffuseTransmission&) { return "diffuse_transmission"; }
inline const char* type_name(const RoughDiffuse&) { return "rough_diffuse"; }
inline const char* type_name(const CoatedDiffuse&) { return "coated_diffuse"; }
inline const char* type_name(const CoatedConductor&) { return "coated_conductor"; }
inline const char* type_name(const Principled&) { return "openpbr"; }
inline const char* type_name(const Hair&) { return "hair"; }
inline const char* type_name(const Measured&) { return "measured"; }
inline const char* type_name(const Interface&) { return "interface"; }
inline const char* type_name(const Mix&) { return "mix"; }
// and of lights.
inline const char* type_name(const MeshLight&) { return "mesh"; }
inline const char* type_name(const SphereLight&) { return "sphere"; }
inline const char* type_name(const PointLight&) { return "point"; }
inline const char* type_name(const SpotLight&) { return "spot"; }
inline const char* type_name(const DirectionalLight&) { return "directional"; }
inline const char* type_name(const AmbientLight&) { return "ambient"; }
inline const char* type_name(const EnvironmentLight&) { return "environment"; }
inline const char* type_name(const GoniometricLight&) { return "goniometric"; }
inline const char* type_name(const ProjectionLight&) { return "projection"; }
inline const char* type_name(const SunLight&) { return "sun"; }

template <typename Visit>
void members(const Visit& visit, ConstantTexture& texture) {
  visit("value", texture.value, Valid::any);
}
template <typename Visit>
void members(const Visit& visit, ImageTexture& texture) {
  visit("wrap", texture.wrap);
  visit("filter", texture.filter);
  visit("uv", texture.uv);
  visit.later("coordinates", texture.coordinates);
}
/// The textures that one is made of.
template <typename Visit>
void two_parts(const Visit& visit, auto& texture) {
  visit("first", texture.first);
  visit("second", texture.second);
}
template <typename Visit>
void members(const Visit& visit, ScaleTexture& texture) {
  two_parts(visit, texture);
}
template <typename Visit>
void members(const Visit& visit, MixTexture& texture) {
  two_parts(visit, texture);
  visit("amount", texture.amount);
}
template <typename Visit>
void members(const Visit& visit, CheckerboardTexture& texture) {
  two_parts(visit, texture);
  visit("uv", texture.uv);
}

template <typename Visit>
void members(const Visit& visit, CubesTexture& texture) {
  two_parts(visit, texture);
}
template <typename Visit>
void members(const Visit& visit, DotsTexture& texture) {
  two_parts(visit, texture);
  visit("uv", texture.uv);
}
template <typename Visit>
void members(const Visit& visit, BilinearTexture& texture) {
  visit("v00", texture.v00, Valid::any);
  visit("v10", texture.v10, Valid::any);
  visit("v01", texture.v01, Valid::any);
  visit("v11", texture.v11, Valid::any);
  visit("uv", texture.uv);
}
template <typename Visit>
void members(const Visit& visit, DirectionMixTexture& texture) {
  two_parts(visit, texture);
  visit.direction("direction", texture.direction);
}
template <typename Visit>
void members(const Visit& visit, NoiseTexture& texture) {
  visit("pattern", texture.pattern);
  visit("octaves", texture.octaves.most);
  visit("roughness", texture.octaves.roughness, Valid::any);
  visit("scale", texture.scale, Valid::any);
  visit("variation", texture.variation, Valid::any);
}
template <typename Visit>
void members(const Visit& visit, PlacedTexture& texture) {
  visit("texture", texture.texture);
  visit("placement", texture.placement);
  visit("to_texture", texture.to_texture);
}

/// What a texture gives a material.
template <typename Visit>
void members(const Visit& visit, TextureUse& use) {
  visit("input", use.input);
  visit("texture", use.texture);
  visit("meaning", use.meaning);
}

template <typename Visit>
void members(const Visit& visit, Lambert& m) {
  visit("reflectance", m.reflectance, Valid::part);
}
template <typename Visit>
void members(const Visit& visit, Mirror& m) {
  visit("reflectance", m.reflectance, Valid::part);
}
template <typename Visit>
void members(const Visit& visit, Refraction& m) {
  visit("transmittance", m.transmittance, Valid::part);
  visit("roughness", m.roughness, Valid::not_negative);
  visit("ior", m.ior, Valid::positive);
}
template <typename Visit>
void members(const Visit& visit, Glass& m) {
  visit("transmittance", m.transmittance, Valid::part);
  visit("reflectance", m.reflectance, Valid::part);
  visit("roughness", m.roughness, Valid::not_negative);
  visit("ior", m.ior, Valid::positive);
}
template <typename Visit>
void members(const Visit& visit, Microfacet& m) {
  visit.constant("distribution", "beckmann");
  visit("alpha", m.alpha, Valid::positive);
  visit("eta", m.eta, Valid::not_negative);
  visit("k", m.k, Valid::not_negative);
}
template <typename Visit>
void members(const Visit& visit, Dielectric& m) {
  visit("ior", m.ior, Valid::positive);
  visit("alpha", m.roughness, Valid::part);
  visit("reflectance", m.reflectance, Valid::part);
  visit("transmittance", m.transmittance, Valid::part);
}
template <typename Visit>
void members(const Visit& visit, Conductor& m) {
  visit("eta", m.eta, Valid::not_negative);
  visit("k", m.k, Valid::not_negative);
  visit("alpha", m.roughness, Valid::part);
  visit("reflectance", m.reflectance, Valid::part);
}
template <typename Visit>
void members(const Visit& visit, DiffuseTransmission& m) {
  visit("reflectance", m.reflectance, Valid::part);
  visit("transmittance", m.transmittance, Valid::part);
}
template <typename Visit>
void members(const Visit& visit, RoughDiffuse& m) {
  visit("reflectance", m.reflectance, Valid::part);
  visit("roughness", m.roughness, Valid::part);
}
template <typename Visit>
void members(const Visit& visit, Hair& m) {
  visit("reflectance", m.reflectance, Valid::part);
  visit("longitudinal_roughness", m.longitudinal_roughness, Valid::part);
  visit("azimuthal_roughness", m.azimuthal_roughness, Valid::part);
  visit("scale_tilt", m.scale_tilt, Valid::any);
  visit("ior", m.ior, Valid::at_least_one);
}
template <typename Visit>
void members(const Visit& visit, CoatedDiffuse& m) {
  visit("reflectance", m.reflectance, Valid::part);
  visit("alpha", m.roughness, Valid::part);
  visit("ior", m.ior, Valid::positive);
}
template <typename Visit>
void members(const Visit& visit, CoatedConductor& m) {
  visit("eta", m.eta, Valid::not_negative);
  visit("k", m.k, Valid::not_negative);
  visit("alpha", m.roughness, Valid::part);
  visit("reflectance", m.reflectance, Valid::part);
  visit("coat_alpha", m.coat_roughness, Valid::part);
  visit("coat_ior", m.coat_ior, Valid::positive);
}
template <typename Visit>
void members(const Visit& visit, Principled& m) {
  visit("base_weight", m.base_weight, Valid::part);
  visit("base_color", m.base_color, Valid::part);
  visit("base_diffuse_roughness", m.base_diffuse_roughness, Valid::part);
  visit("base_metalness", m.base_metalness, Valid::part);
  visit.later("subsurface_weight", m.subsurface_weight, Valid::part);
  visit.later("subsurface_color", m.subsurface_color, Valid::part);
  visit("specular_weight", m.specular_weight, Valid::part);
  visit("specular_color", m.specular_color, Valid::part);
  visit("specular_roughness", m.specular_roughness, Valid::part);
  visit("specular_roughness_anisotropy", m.specular_roughness_anisotropy, Valid::part);
  visit("specular_ior", m.specular_ior, Valid::positive);
  visit("transmission_weight", m.transmission_weight, Valid::part);
  visit("transmission_color", m.transmission_color, Valid::part);
  visit("transmission_depth", m.transmission_depth, Valid::not_negative);
  visit("coat_weight", m.coat_weight, Valid::part);
  visit("coat_color", m.coat_color, Valid::part);
  visit("coat_roughness", m.coat_roughness, Valid::part);
  visit("coat_ior", m.coat_ior, Valid::at_least_one);
  visit("coat_darkening", m.coat_darkening, Valid::part);
  visit("fuzz_weight", m.fuzz_weight, Valid::part);
  visit("fuzz_color", m.fuzz_color, Valid::part);
  visit("fuzz_roughness", m.fuzz_roughness, Valid::part);
  visit.later("thin_film_weight", m.thin_film_weight, Valid::part);
  visit.later("thin_film_thickness", m.thin_film_thickness, Valid::film_thickness);
  visit.later("thin_film_ior", m.thin_film_ior, Valid::film_ior);
  visit("emission_luminance", m.emission_luminance, Valid::not_negative);
  visit("emission_color", m.emission_color, Valid::not_negative);
  visit("geometry_thin_walled", m.geometry_thin_walled);
}
/// What was measured is in a file of its own.
template <typename Visit>
void members(const Visit&, Measured&) {}
template <typename Visit>
void members(const Visit&, Interface&) {}
template <typename Visit>
void members(const Visit& visit, Mix& m) {
  visit("first", m.first);
  visit("second", m.second);
  visit("amount", m.amount, Valid::part);
}

template <typename Visit>
void members(const Visit& visit, Interior& interior) {
  visit("absorption", interior.absorption, Valid::not_negative);
  visit("priority", interior.priority);
  visit.later("is_clear", interior.is_clear);
  visit.later("scattering", interior.scattering, Valid::not_negative);
  visit.later("anisotropy", interior.anisotropy, Valid::anisotropy);
}

template <typename Visit>
void members(const Visit& visit, Glow& glow) {
  visit("radiance", glow.radiance, Valid::not_negative);
  visit("temperature_offset", glow.temperature_offset, Valid::any);
  visit("temperature_scale", glow.temperature_scale, Valid::any);
}

template <typename Visit>
void members(const Visit& visit, Subsurface& subsurface) {
  visit("radius", subsurface.radius, Valid::positive);
  visit("anisotropy", subsurface.anisotropy, Valid::anisotropy);
}

template <typename Visit>
void members(const Visit& visit, PixelFilter& filter) {
  visit("type", filter.kind);
  visit("radius", filter.radius);
  visit.later("sigma", filter.sigma, Valid::positive);
  visit.later("b", filter.b, Valid::part);
  visit.later("c", filter.c, Valid::part);
}

/// The three coefficients of the fall-off with distance.
template <typename Visit>
void members(const Visit& visit, Attenuation& attenuation) {
  visit("constant", attenuation.constant, Valid::not_negative);
  visit("linear", attenuation.linear, Valid::not_negative);
  visit("quadratic", attenuation.quadratic, Valid::not_negative);
}

template <typename Visit>
void members(const Visit& visit, MeshLight& light) {
  visit("shape", light.shape);
  visit("radiance", light.radiance, Valid::not_negative);
  visit("side", light.side);
}
/// How the picture of a MeshLight lies, which older files do not say.
template <typename Visit, typename Light>
void picture_members(const Visit& visit, Light& light) {
  visit.later("wrap", light.wrap);
  visit.later("filter", light.filter);
  visit.later("uv", light.uv);
}
template <typename Visit>
void members(const Visit& visit, SphereLight& light) {
  visit("shape", light.shape);
  visit("radiance", light.radiance, Valid::not_negative);
}
template <typename Visit>
void members(const Visit& visit, PointLight& light) {
  visit("position", light.position);
  visit("intensity", light.intensity, Valid::not_negative);
  visit.later("attenuation", light.attenuation);
}
template <typename Visit>
void members(const Visit& visit, SpotLight& light) {
  visit("position", light.position);
  visit.direction("direction", light.direction);
  visit("intensity", light.intensity, Valid::not_negative);
  visit.later("attenuation", light.attenuation);
  visit("falloff_angle_degrees", light.falloff_angle_degrees, Valid::positive);
  visit("falloff_exponent", light.falloff_exponent, Valid::not_negative);
  visit("penumbra_degrees", light.penumbra_degrees, Valid::not_negative);
}
template <typename Visit>
void members(const Visit& visit, DirectionalLight& light) {
  visit.direction("direction", light.direction);
  visit("irradiance", light.irradiance, Valid::not_negative);
}
template <typename Visit>
void members(const Visit& visit, AmbientLight& light) {
  visit.direction("up", light.up);
  visit("radiance", light.radiance, Valid::not_negative);
}
template <typename Visit>
void members(const Visit& visit, EnvironmentLight& light) {
  visit("layout", light.layout);
  visit("rotation", light.rotation);
  visit("scale", light.scale, Valid::not_negative);
}
template <typename Visit>
void members(const Visit& visit, GoniometricLight& light) {
  visit("position", light.position);
  visit("intensity", light.intensity, Valid::not_negative);
  visit("layout", light.layout);
  visit("rotation", light.rotation);
}
template <typename Visit>
void members(const Visit& visit, ProjectionLight& light) {
  visit("position", light.position);
  visit.direction("right", light.right);
  visit.direction("up", light.up);
  visit.direction("forward", light.forward);
  visit("tan_half_width", light.tan_half_width, Valid::positive);
  visit("tan_half_height", light.tan_half_height, Valid::positive);
  visit("intensity", light.intensity, Valid::not_negative);
}
template <typename Visit>
void members(const Visit& visit, SunLight& light) {
  visit.direction("direction", light.direction);
  visit("irradiance", light.irradiance, Valid::not_negative);
  visit("diameter_degrees", light.diameter_degrees, Valid::positive);
}

}  // namespace twinray
