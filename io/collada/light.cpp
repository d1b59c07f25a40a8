// SPDX-License-Identifier: Apache-2.0
#include "io/collada/light.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/radiance.h"

namespace twinray {
namespace {

/// Of a point or spot light: falling off with the squared distance, from afar it may exceed max_radiance.
constexpr float most_intensity = 1e18f;
constexpr double most_attenuation = 1e18;

/// The element that names the kind of light and holds its numbers.
std::optional<XmlElement> kind_within(const XmlElement& technique, std::initializer_list<const char*> kinds) {
  for (const XmlElement& child : technique.children())
    for (const char* kind : kinds)
      if (child.is(kind)) return child;
  return std::nullopt;
}

XmlElement kind_of(const XmlElement& light) {
  if (const auto technique = cgl_technique(light))
    if (const auto kind = kind_within(*technique, {"area", "point", "spot", "directional", "ambient"}))
      return *kind;
  const XmlElement common = light.required_child("technique_common");
  if (const auto kind = kind_within(common, {"point", "spot", "directional", "ambient"})) return *kind;
  common.fail("<technique_common> of a light needs <point>, <spot>, <directional> or <ambient>");
}

bool has_attenuation(const XmlElement& kind) {
  return kind.child("constant_attenuation") || kind.child("linear_attenuation") ||
         kind.child("quadratic_attenuation");
}

/// The file's attenuation: COLLADA's defaults (1, 0, 0) for those of the three terms that it leaves out.
/// Where it has none of them, that or the inverse square law.
Attenuation read_attenuation(const XmlElement& kind, const LoadOptions& options) {
  if (!has_attenuation(kind) && !options.attenuation_as_file) return {};
  const auto constant = kind.child("constant_attenuation"), linear = kind.child("linear_attenuation"),
             quadratic = kind.child("quadratic_attenuation");
  const auto value = [](const std::optional<XmlElement>& element, float fallback) {
    return element ? float(number_in(*element, 0, most_attenuation)) : fallback;
  };
  const Attenuation result{value(constant, 1), value(linear, 0), value(quadratic, 0)};
  if (result.constant == 0 && result.linear == 0 && result.quadratic == 0)
    kind.fail("the three attenuations of this light are 0; at least one must be above 0");
  return result;
}

/// The unit vector along which the node's -z points.
Vec3 direction_of(const XmlElement& instance, const Transform& to_world) {
  const double x = -to_world.m[0][2], y = -to_world.m[1][2], z = -to_world.m[2][2];
  const double length = std::sqrt(x * x + y * y + z * z);
  if (!(length > 0) || !std::isfinite(length))
    instance.fail("the transform of this light's node gives it no direction: it flattens the z axis");
  return {float(x / length), float(y / length), float(z / length)};
}

Vec3 position_of(const XmlElement& instance, const Transform& to_world) {
  const Vec3 position = to_world.point({0, 0, 0});
  if (!is_finite(position) || max_abs(position) > max_coordinate)
    instance.fail(
        fmt::format("this light stands at ({}, {}, {}); coordinates must be finite and within +-{:g}",
                    position.x, position.y, position.z, max_coordinate));
  return position;
}

std::optional<PlacedLight> place_area(const XmlElement& light, const XmlElement& instance,
                                      const XmlElement& kind, const Transform& to_world,
                                      ColladaDocument& document) {
  AreaLight area;
  area.name = display_name(light);
  area.radiance = read_color(kind.required_child("color"), max_radiance);
  constexpr float half = 0.5f;
  const Vec3 square[4] = {{-half, -half, 0}, {-half, half, 0}, {half, half, 0}, {half, -half, 0}};
  std::transform(std::begin(square), std::end(square), area.corners,
                 [&](const Vec3& p) { return to_world.point(p); });
  if (to_world.determinant() < 0) std::swap(area.corners[1], area.corners[3]);
  position_of(instance, to_world);
  Mesh mesh = area_light_mesh(area);
  if (drop_degenerate_triangles(mesh) == 0) return area;
  document.warn(instance, "the transform of this area light's node leaves it no area; it is left out");
  return std::nullopt;
}

SpotLight read_spot(const XmlElement& instance, const XmlElement& kind, const Transform& to_world,
                    const LoadOptions& options) {
  SpotLight spot;
  spot.position = position_of(instance, to_world);
  spot.direction = direction_of(instance, to_world);
  spot.intensity = read_color(kind.required_child("color"), most_intensity);
  spot.attenuation = read_attenuation(kind, options);
  if (const auto angle = kind.child("falloff_angle"))
    spot.falloff_angle_degrees = float(number_in(*angle, 1e-3, 360));
  if (const auto exponent = kind.child("falloff_exponent"))
    spot.falloff_exponent = float(number_in(*exponent, 0, 1e4));
  return spot;
}

/// The program takes the point one unit in front of the node for a direction from the world's origin, so the
/// node's translation counts.
Vec3 cs184_direction_of(const XmlElement& instance, const Transform& t) {
  const double x = t.m[0][3] - t.m[0][2], y = t.m[1][3] - t.m[1][2], z = t.m[2][3] - t.m[2][2];
  const double length = std::sqrt(x * x + y * y + z * z);
  if (!(length > 0) || !std::isfinite(length))
    instance.fail(
        "by CS184's rules this light comes from the point one unit in front of its node, and that is the "
        "origin: it has no direction");
  return {float(-x / length), float(-y / length), float(-z / length)};
}

/// Nothing for a spot light, which lights nothing in CS184's program.
std::optional<LightSource> read_cs184_light(const XmlElement& instance, const XmlElement& kind,
                                            const Transform& to_world, ColladaDocument& document) {
  if (kind.is("spot")) {
    document.warn(instance, "a spot light gives no light in CS184's program; it is left out");
    return std::nullopt;
  }
  const Rgb color = read_color(kind.required_child("color"), max_radiance);
  if (kind.is("point")) return PointLight{position_of(instance, to_world), color, {1, 0, 0}};
  if (kind.is("directional")) return DirectionalLight{cs184_direction_of(instance, to_world), color};
  return AmbientLight{{0, 1, 0}, color};
}

LightSource read_source_light(const XmlElement& instance, const XmlElement& kind, const Transform& to_world,
                              const LoadOptions& options) {
  if (kind.is("spot")) return read_spot(instance, kind, to_world, options);
  const Rgb color =
      read_color(kind.required_child("color"), kind.is("point") ? most_intensity : max_radiance);
  if (kind.is("point"))
    return PointLight{position_of(instance, to_world), color, read_attenuation(kind, options)};
  if (kind.is("directional")) return DirectionalLight{direction_of(instance, to_world), color};
  return AmbientLight{{0, 1, 0}, color};
}

}  // namespace

Mesh area_light_mesh(const AreaLight& light) {
  Mesh mesh;
  mesh.name = light.name;
  mesh.positions.assign(std::begin(light.corners), std::end(light.corners));
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

std::optional<PlacedLight> read_light(const XmlElement& light, const XmlElement& instance,
                                      const Transform& to_world, ColladaDocument& document) {
  const XmlElement kind = kind_of(light);
  if (kind.is("area")) return place_area(light, instance, kind, to_world, document);
  if (document.options().interpretation == Interpretation::cs184) {
    const auto source = read_cs184_light(instance, kind, to_world, document);
    if (!source) return std::nullopt;
    return Light{display_name(light), *source};
  }
  return Light{display_name(light), read_source_light(instance, kind, to_world, document.options())};
}

bool lacks_attenuation(const XmlElement& light) {
  const XmlElement kind = kind_of(light);
  return (kind.is("point") || kind.is("spot")) && !has_attenuation(kind);
}

}  // namespace twinray
