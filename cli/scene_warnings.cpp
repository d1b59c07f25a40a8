// SPDX-License-Identifier: Apache-2.0
#include "cli/scene_warnings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <utility>
#include <variant>

#include "core/light_set.h"

namespace twinray {
namespace {

/// By the index of SurfaceModel: what it is called, and which of its numbers stands in for it.
constexpr std::array<std::array<const char*, 2>, std::variant_size_v<SurfaceModel>> models{
    {{"lambert", "reflectance"},
     {"mirror", "reflectance"},
     {"refraction", "transmittance"},
     {"glass", "transmittance"},
     {"microfacet", "reflectance at normal incidence"}}};

/// A measure of a light that is black where it sends none.
struct Strength {
  Rgb operator()(const MeshLight& light) const { return light.radiance; }
  Rgb operator()(const SphereLight& light) const { return light.radiance; }
  Rgb operator()(const PointLight& light) const { return light.intensity; }
  Rgb operator()(const SpotLight& light) const { return light.intensity; }
  Rgb operator()(const DirectionalLight& light) const { return light.irradiance; }
  Rgb operator()(const AmbientLight& light) const { return light.radiance; }
  Rgb operator()(const EnvironmentLight& light) const {
    const std::vector<Rgb>& pixels = light.map->pixels;
    const auto bright = std::find_if_not(pixels.begin(), pixels.end(), is_black);
    return bright == pixels.end() ? Rgb{} : *bright;
  }
};

bool is_lit(const Scene& scene) {
  return std::any_of(scene.lights.begin(), scene.lights.end(),
                     [](const Light& light) { return !is_black(std::visit(Strength{}, light.source)); });
}

std::string unmet_lights(const Scene& scene) {
  const LightSet lights(scene);
  std::vector<std::string> names;
  for (std::uint32_t light = 0; light < lights.size(); ++light)
    if (lights.is_delta(light)) names.push_back(fmt::format("\"{}\"", scene.lights[light].name));
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
  if (!is_lit(scene)) add("the scene has no light: the picture will be black");
  if (arguments.path.direct == DirectMethod::hemisphere) add(unmet_lights(scene));
  for (std::size_t model = 1; model < models.size(); ++model) add(stand_in(scene, model));
  return warnings;
}

}  // namespace twinray
