// SPDX-License-Identifier: Apache-2.0
#include "cli/scene_warnings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <utility>
#include <variant>

#include "cli/default_light.h"

namespace twinray {
namespace {

/// By the index of SurfaceModel: what it is called, and which of its numbers stands in for it.
constexpr std::array<std::array<const char*, 2>, std::variant_size_v<SurfaceModel>> models{
    {{"lambert", "reflectance"},
     {"mirror", "reflectance"},
     {"refraction", "transmittance"},
     {"glass", "transmittance"},
     {"microfacet", "reflectance at normal incidence"},
     {"dielectric", "transmittance"},
     {"conductor", "reflectance at normal incidence"},
     {"diffuse transmission", "reflectance"},
     {"rough diffuse", "reflectance"},
     {"coated diffuse", "reflectance"},
     {"coated conductor", "reflectance at normal incidence"},
     {"mix", "mean, grey,"}}};

std::string unmet_lights(const Scene& scene) {
  std::vector<std::string> names;
  for (const Light& light : scene.lights)
    if (is_delta(light.source)) names.push_back(fmt::format("\"{}\"", light.name));
  if (names.empty()) return {};
  return fmt::format(
      "hemisphere sampling finds no light from a point or a single direction: {} {} nothing to the "
      "picture; --direct=lights would show {}",
      fmt::join(names, ", "), names.size() == 1 ? "adds" : "add", names.size() == 1 ? "it" : "them");
}

std::string stand_in(const Scene& scene, std::size_t model) {
  std::vector<std::string> names;
  for (const Material& material : scene.materials)
    if (material.model.index() == model) names.push_back(fmt::format("\"{}\"", material.name));
  if (names.empty()) return {};
  return fmt::format("{} is rendered as Lambert of its {}: {}", models[model][0], models[model][1],
                     fmt::join(names, ", "));
}

}  // namespace

std::vector<std::string> scene_warnings(const Scene& scene, const RenderArguments& arguments) {
  if (arguments.integrator == IntegratorKind::normals || arguments.integrator == IntegratorKind::cost)
    return {};
  std::vector<std::string> warnings;
  const auto add = [&warnings](std::string warning) {
    if (!warning.empty()) warnings.push_back(std::move(warning));
  };
  if (!is_lit(scene))
    add("the scene has no light: the picture will be black; --default-light puts a light at the camera");
  if (arguments.path.direct == DirectMethod::hemisphere) add(unmet_lights(scene));
  for (std::size_t model = 1; model < models.size(); ++model) add(stand_in(scene, model));
  return warnings;
}

}  // namespace twinray
