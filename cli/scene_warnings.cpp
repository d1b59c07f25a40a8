// SPDX-License-Identifier: Apache-2.0
#include "cli/scene_warnings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>
#include <variant>

#include "cli/default_light.h"
#include "core/light_set.h"
#include "core/radiance.h"

namespace twinray {
namespace {

std::string unmet_lights(const Scene& scene) {
  std::vector<std::string> names;
  for (const Light& light : scene.lights)
    if (is_delta(light.source) || is_invisible(scene, light.source))
      names.push_back(fmt::format("\"{}\"", light.name));
  if (names.empty()) return {};
  return fmt::format(
      "hemisphere sampling finds no light from a point, a single direction or an invisible shape: {} {} "
      "nothing to the "
      "picture; --direct=lights would show {}",
      fmt::join(names, ", "), names.size() == 1 ? "adds" : "add", names.size() == 1 ? "it" : "them");
}

/// Of an environment some of whose pixels are brighter than what a film takes: they count as that
/// (core/environment.h).
std::string cut_off(const Light& light) {
  const auto* const sky = std::get_if<EnvironmentLight>(&light.source);
  if (!sky) return {};
  const std::size_t count =
      std::size_t(std::count_if(sky->map->pixels.begin(), sky->map->pixels.end(), [&](const Rgb& pixel) {
        return max_component(sky->scale * pixel) > max_radiance;
      }));
  if (count == 0) return {};
  return fmt::format("\"{}\": pixels brighter than 1e9, which count as that: {}", light.name, count);
}

}  // namespace

std::vector<std::string> scene_warnings(const Scene& scene, const RenderArguments& arguments) {
  if (!traces_paths(arguments.integrator)) return {};
  std::vector<std::string> warnings;
  const auto add = [&warnings](std::string warning) {
    if (!warning.empty()) warnings.push_back(std::move(warning));
  };
  if (!is_lit(scene))
    add("the scene has no light: the picture will be black; --default-light lights it by a soft sky");
  if (arguments.path.direct == DirectMethod::hemisphere) add(unmet_lights(scene));
  for (const Light& light : scene.lights) add(cut_off(light));
  return warnings;
}

}  // namespace twinray
