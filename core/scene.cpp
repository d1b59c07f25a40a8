// SPDX-License-Identifier: Apache-2.0
#include "core/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/check_light.h"
#include "core/error.h"
#include "core/interiors.h"
#include "core/nested_mixes.h"
#include "core/phase_function.h"
#include "core/scene_textures.h"
#include "core/textured_material.h"

namespace twinray {
namespace {

void check_light(const Scene& scene, std::size_t index) {
  const std::size_t shapes = scene.geometry->shapes().size();
  const auto* mesh = std::get_if<MeshLight>(&scene.lights[index].source);
  if (mesh && (mesh->shape >= shapes || !scene.geometry->mesh(mesh->shape)))
    throw Error(fmt::format("light {} names shape {}, which is not a mesh", index, mesh->shape));
  const auto* sphere = std::get_if<SphereLight>(&scene.lights[index].source);
  if (sphere && (sphere->shape >= shapes || !scene.geometry->sphere_set(sphere->shape) ||
                 scene.geometry->sphere_set(sphere->shape)->spheres.size() != 1))
    throw Error(
        fmt::format("light {} names shape {}, which is not a set of one sphere", index, sphere->shape));
  const std::uint32_t shape = mesh ? mesh->shape : sphere ? sphere->shape : 0;
  if ((mesh || sphere) && shape >= scene.geometry->direct_shapes().count)
    throw Error(fmt::format("light {} names shape {}, which only instances show", index, shape));
  check_numbers(scene.lights[index].source, fmt::format("light {}", index));
  if (!scene.light_groups.empty() && scene.lights[index].group >= scene.light_groups.size())
    throw Error(fmt::format("light {} names group {}; there are {}", index, scene.lights[index].group,
                            scene.light_groups.size()));
}

void check_binding(const Scene& scene, std::uint32_t shape) {
  const ShapeBinding& binding = scene.bindings[shape];
  if (binding.material >= scene.materials.size())
    throw Error(fmt::format("shape {} names material {}; there are {}", shape, binding.material,
                            scene.materials.size()));
  if (binding.light != no_light && binding.light >= scene.lights.size())
    throw Error(
        fmt::format("shape {} names light {}; there are {}", shape, binding.light, scene.lights.size()));
  if (binding.light != no_light && std::holds_alternative<Interface>(scene.materials[binding.material].model))
    throw Error(
        fmt::format("shape {} emits light, but its material {} is no surface: an interface emits none", shape,
                    binding.material));
  if (binding.asset != no_asset && binding.asset >= scene.assets.size())
    throw Error(
        fmt::format("shape {} names asset {}; there are {}", shape, binding.asset, scene.assets.size()));
  const bool has_alpha = binding.alpha != no_texture;
  if (has_alpha && binding.alpha >= scene.textures.size())
    throw Error(
        fmt::format("shape {} names texture {}; there are {}", shape, binding.alpha, scene.textures.size()));
  if (has_alpha && goes_by_second_uvs(scene.textures, binding.alpha))
    throw Error(
        fmt::format("shape {} has an alpha, texture {}, by second texture coordinates; valid are the "
                    "first ones",
                    shape, binding.alpha));
  if (scene.geometry->is_opaque(shape) == has_alpha)
    throw Error(fmt::format("shape {} has {} alpha, but its geometry is{} opaque", shape,
                            has_alpha ? "an" : "no", has_alpha ? "" : " not"));
}

/// Some meanings are of one input each.
void check_meaning(const TextureUse& use, std::size_t index) {
  struct Only {
    InputMeaning meaning;
    const char* name;
    MaterialInput input;
  };
  constexpr Only onlys[] = {
      {InputMeaning::widening, "widening", MaterialInput::specular_roughness_anisotropy},
      {InputMeaning::weighted_color, "weighted_color", MaterialInput::fuzz_color},
      {InputMeaning::emerging, "emerging", MaterialInput::reflectance}};
  for (const Only& only : onlys)
    if (use.meaning == only.meaning && use.input != only.input)
      throw Error(fmt::format("material {} has a texture whose meaning is \"{}\" for its {}; valid is {}",
                              index, only.name, input_name(use.input), input_name(only.input)));
}

void check_material(const Scene& scene, std::size_t index) {
  const Material& material = scene.materials[index];
  const auto* mix = std::get_if<Mix>(&material.model);
  if (mix && (mix->first >= index || mix->second >= index))
    throw Error(fmt::format("material {} mixes materials {} and {}; valid are those before it", index,
                            mix->first, mix->second));
  for (const std::uint32_t map : {material.normal_map, material.bump_map, material.tangent_map}) {
    if (map == no_texture) continue;
    if (map >= scene.textures.size())
      throw Error(
          fmt::format("material {} names texture {}; there are {}", index, map, scene.textures.size()));
    if (goes_by_second_uvs(scene.textures, map))
      throw Error(
          fmt::format("material {} has a map, texture {}, by second texture coordinates; valid are "
                      "the first ones",
                      index, map));
  }
  for (const TextureUse& use : material.textures) {
    if (use.texture >= scene.textures.size())
      throw Error(fmt::format("material {} names texture {}; there are {}", index, use.texture,
                              scene.textures.size()));
    if (!has_input(material.model, use.input))
      throw Error(fmt::format("material {} has a texture for its {}, and its model has none", index,
                              input_name(use.input)));
    check_meaning(use, index);
  }
  if (!(std::fabs(material.tangent_degrees) <= 360))
    throw Error(fmt::format("material {} has a tangent turned by {:g} degrees; valid are -360 to 360", index,
                            material.tangent_degrees));
}

void check_measured(const Scene& scene, std::size_t index) {
  const auto* const measured = std::get_if<Measured>(&scene.materials[index].model);
  if (measured && !measured->brdf)
    throw Error(fmt::format("material {} is a measured one without a measurement", index));
}

void check_interior(const Scene& scene, std::size_t index) {
  const Material& material = scene.materials[index];
  if (!has_interior(material)) return;
  if (!lets_light_in(material))
    throw Error(fmt::format("material {} has an interior, and its surface lets no light in", index));
  if (index >= Interiors::most_materials)
    throw Error(fmt::format("material {} has an interior; only the first {} materials may", index,
                            Interiors::most_materials));
  const Rgb& absorption = material.interior.absorption;
  if (!is_finite(absorption) || std::min({absorption.r, absorption.g, absorption.b}) < 0)
    throw Error(fmt::format("material {} has an absorption of {:g} {:g} {:g}; each must be finite and >= 0",
                            index, absorption.r, absorption.g, absorption.b));
  const Rgb& scattering = material.interior.scattering;
  if (!is_finite(scattering) || std::min({scattering.r, scattering.g, scattering.b}) < 0)
    throw Error(fmt::format("material {} has a scattering of {:g} {:g} {:g}; each must be finite and >= 0",
                            index, scattering.r, scattering.g, scattering.b));
  if (!is_finite(material.interior.extinction()))
    throw Error(fmt::format("material {} absorbs and scatters more than a number can say", index));
  if (!(std::fabs(material.interior.anisotropy) <= PhaseFunction::most_anisotropy))
    throw Error(fmt::format("material {} has an anisotropy of {:g}; valid are -{:g} to {:g}", index,
                            material.interior.anisotropy, PhaseFunction::most_anisotropy,
                            PhaseFunction::most_anisotropy));
  const Glow& glow = material.interior.glow;
  for (const std::uint32_t density : {material.interior.density, glow.factor, glow.temperature})
    if (density != no_density && density >= scene.densities.size())
      throw Error(
          fmt::format("material {} names density {}; there are {}", index, density, scene.densities.size()));
  const Rgb& radiance = glow.radiance;
  if (!is_finite(radiance) || std::min({radiance.r, radiance.g, radiance.b}) < 0 ||
      !is_finite(material.interior.emission()))
    throw Error(
        fmt::format("material {} glows with a radiance of {:g} {:g} {:g}; each must be finite and >= 0, "
                    "and also times the absorption",
                    index, radiance.r, radiance.g, radiance.b));
  if (!std::isfinite(glow.temperature_offset) || !std::isfinite(glow.temperature_scale))
    throw Error(fmt::format("material {} has a temperature of media that is not finite", index));
  if (material.interior.priority < 0)
    throw Error(
        fmt::format("material {} has the priority {}; it must be >= 0", index, material.interior.priority));
}

void check_subsurface(const Scene& scene, std::size_t index) {
  const Material& material = scene.materials[index];
  const auto& [radius, anisotropy] = material.subsurface;
  if (!has_subsurface(material)) return;
  if (!may_have_subsurface(material.model))
    throw Error(fmt::format("material {} has a subsurface, and its model has no base above it", index));
  if (!is_finite(radius) || !(std::min({radius.r, radius.g, radius.b}) > 0))
    throw Error(
        fmt::format("material {} has a subsurface of the radius {:g} {:g} {:g}; each must be finite and > 0",
                    index, radius.r, radius.g, radius.b));
  if (!(std::fabs(anisotropy) <= PhaseFunction::most_anisotropy))
    throw Error(fmt::format("material {} has a subsurface of the anisotropy {:g}; valid are -{:g} to {:g}",
                            index, anisotropy, PhaseFunction::most_anisotropy,
                            PhaseFunction::most_anisotropy));
}

void check_atmosphere(const Scene& scene) {
  if (scene.atmosphere == no_material) return;
  if (scene.atmosphere >= scene.materials.size())
    throw Error(fmt::format("the atmosphere is that of material {}; there are {}", scene.atmosphere,
                            scene.materials.size()));
  if (!std::holds_alternative<Interface>(scene.materials[scene.atmosphere].model))
    throw Error(
        fmt::format("the atmosphere is that of material {}, which is not an interface", scene.atmosphere));
}

/// Once each mix is known to be of materials before it.
void check_mixes(std::span<const Material> materials) {
  std::vector<int> nested(materials.size());
  for (std::size_t i = 0; i < materials.size(); ++i) {
    const auto* mix = std::get_if<Mix>(&materials[i].model);
    if (!mix) continue;
    nested[i] = 1 + std::max(nested[mix->first], nested[mix->second]);
    if (nested[i] > most_nested_mixes)
      throw Error(fmt::format("material {} is a mix in which mixes are {} deep; valid are up to {}", i,
                              nested[i], most_nested_mixes));
  }
}

}  // namespace

void check_scene(const Scene& scene) {
  for (std::size_t i = 0; i < scene.materials.size(); ++i)
    check_measured(scene, i), check_interior(scene, i), check_subsurface(scene, i);
  if (scene.bindings.size() != scene.geometry->shapes().size())
    throw Error(
        fmt::format("{} shapes but {} bindings", scene.geometry->shapes().size(), scene.bindings.size()));
  for (std::size_t i = 0; i < scene.bindings.size(); ++i) check_binding(scene, std::uint32_t(i));
  for (std::size_t i = 0; i < scene.lights.size(); ++i) check_light(scene, i);
  check_textures(scene.textures);
  for (std::size_t i = 0; i < scene.materials.size(); ++i) check_material(scene, i);
  check_mixes(scene.materials);
  check_atmosphere(scene);
  if (!scene.light_groups.empty() && has_glow(scene.materials) &&
      scene.media_group >= scene.light_groups.size())
    throw Error(fmt::format("light of media is of no group; there are {}", scene.light_groups.size()));
}

}  // namespace twinray
