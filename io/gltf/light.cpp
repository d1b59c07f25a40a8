// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/light.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <cmath>

#include "io/gltf/document.h"

namespace twinray {
namespace {

constexpr double degrees_per_radian = 57.29577951308232;

Rgb amount_of(const tinygltf::Light& light) {
  const auto strength = float(light.intensity);
  if (light.color.size() < 3) return {strength, strength, strength};
  return Rgb{float(light.color[0]), float(light.color[1]), float(light.color[2])} * strength;
}

/// The edge falls off between the two angles; the extension gives its curve as a proposal.
SpotLight spot_of(const tinygltf::Light& light, const std::string& pointer, const GltfContext& context) {
  SpotLight spot;
  const double inner = light.spot.innerConeAngle, outer = light.spot.outerConeAngle;
  if (!(inner <= outer) || !(outer > 0))
    context.fail(pointer + "/spot",
                 fmt::format("innerConeAngle is {:g} and outerConeAngle {:g}; the inner one "
                             "must be the smaller, the outer one above 0",
                             inner, outer));
  spot.falloff_angle_degrees = float(2 * outer * degrees_per_radian);
  spot.penumbra_degrees = float((outer - inner) * degrees_per_radian);
  return spot;
}

/// None where the transform shrinks it to nothing.
std::optional<Vec3> axis_of(const Transform& to_world) {
  const Vec3 axis = to_world.vector({0, 0, -1});
  const float size = length(axis);
  return size > 0 && std::isfinite(size) ? std::optional(axis / size) : std::nullopt;
}

}  // namespace

std::optional<Light> read_gltf_light(GltfDocument& document, int index, int node, const Transform& to_world) {
  const auto& model = document.model();
  GltfContext& context = document.context();
  const std::string node_pointer = fmt::format("/nodes/{}", node);
  if (std::size_t(index) >= model.lights.size())
    context.fail(
        node_pointer + "/extensions/KHR_lights_punctual/light",
        fmt::format("the index {} is out of range; the file has {} lights", index, model.lights.size()));
  const tinygltf::Light& source = model.lights[std::size_t(index)];
  const std::string pointer = fmt::format("/extensions/KHR_lights_punctual/lights/{}", index);
  if (source.range > 0 && source.type != "directional")
    context.warn(pointer + "/range", "light without an end is rendered: a range is left out");
  const Rgb amount = amount_of(source);
  Light light;
  light.name = source.name.empty() ? model.nodes[std::size_t(node)].name : source.name;
  if (light.name.empty()) light.name = fmt::format("light {}", index);
  const Vec3 position = to_world.point({0, 0, 0});
  const std::optional<Vec3> axis = axis_of(to_world);
  if (!axis && source.type != "point") {
    context.warn(node_pointer, "the transform of this light's node gives it no direction; it is left out");
    return std::nullopt;
  }
  if (source.type == "point") {
    light.source = PointLight{position, amount, {}};
  } else if (source.type == "directional") {
    light.source = DirectionalLight{*axis, amount};
  } else {
    SpotLight spot = spot_of(source, pointer, context);
    spot.position = position, spot.intensity = amount;
    spot.direction = *axis;
    light.source = spot;
  }
  return light;
}

}  // namespace twinray
