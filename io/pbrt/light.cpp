// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/light.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/angle.h"
#include "core/elementary.h"
#include "io/pbrt/light_strength.h"
#include "io/pbrt/spectrum.h"
#include "io/pbrt/transform.h"
#include "io/picture/environment_file.h"
#include "io/picture/texture_file.h"

namespace twinray {
namespace {

constexpr NumberRange scales{0, 1e12}, any_power{-1e30, 1e30};

/// The color of a light times its scale.
Rgb scaled_color(const PbrtParameters& parameters, const char* name, PbrtContext& context) {
  return color_of(parameters, name, white, ColorRole::light, context.files) *
         parameters.real("scale", 1, scales);
}

/// A power or an illuminance takes the place of "scale" as far as the light of `unit` gives 1. Not above 0:
/// it is not given.
Rgb with_strength(const Rgb& color, const char* name, double unit, const PbrtParameters& parameters) {
  const float wanted = parameters.real(name, -1, any_power);
  return wanted > 0 && unit > 0 ? color * float(double(wanted) / unit) : color;
}

/// The same of a picture, which is added up by `sum` only where that is needed.
template <typename Sum>
Rgb with_strength_of(const Rgb& color, const char* name, const Sum& sum, const PbrtParameters& parameters) {
  return parameters.real(name, -1, any_power) > 0 ? with_strength(color, name, sum(), parameters) : color;
}

Vec3 direction(const Vec3& from, const Vec3& to, const Transform& to_world,
               const PbrtParameters& parameters) {
  const Vec3 d = to_world.vector(to - from);
  if (!(length(d) > 0))
    parameters.place().fail("this light has no direction: \"from\" and \"to\" are one point");
  return normalize(d);
}

std::optional<LightSource> read_point(const PbrtParameters& parameters, const Transform& to_world,
                                      PbrtContext& context) {
  const Rgb intensity = scaled_color(parameters, "I", context);
  return PointLight{to_world.point(parameters.point("from", {0, 0, 0})),
                    with_strength(intensity, "power", 4 * pi_double, parameters),
                    {}};
}

std::optional<LightSource> read_spot(const PbrtParameters& parameters, const Transform& to_world,
                                     PbrtContext& context) {
  const Vec3 from = parameters.point("from", {0, 0, 0}), to = parameters.point("to", {0, 0, 1});
  const float angle = parameters.real("coneangle", 30, {0, 180});
  const float delta = parameters.real("conedeltaangle", 5, {0, 180});
  const double end = cos_radians(double(angle) * radians_per_degree);
  // pbrt takes the cosine of the difference, which may be negative.
  const float inner = std::min(angle, std::fabs(angle - delta));
  const double start = cos_radians(double(inner) * radians_per_degree);
  const Rgb intensity = scaled_color(parameters, "I", context);
  const double unit = 2 * pi_double * ((1 - start) + (start - end) / 2);
  SpotLight spot{to_world.point(from), direction(from, to, to_world, parameters),
                 with_strength(intensity, "power", unit, parameters)};
  spot.falloff_angle_degrees = std::max(2 * angle, 1e-3f);
  spot.penumbra_degrees = std::min(angle - inner, spot.falloff_angle_degrees / 2);
  if (similarity_scale(to_world) == 0)
    parameters.place().warn(context.warnings, "this light's cone stays round, which its transform stretches");
  return spot;
}

std::optional<LightSource> read_distant(const PbrtParameters& parameters, const Transform& to_world,
                                        PbrtContext& context) {
  const Vec3 from = parameters.point("from", {0, 0, 0}), to = parameters.point("to", {0, 0, 1});
  const Rgb irradiance = scaled_color(parameters, "L", context);
  return DirectionalLight{direction(from, to, to_world, parameters),
                          with_strength(irradiance, "illuminance", 1, parameters)};
}

/// The turn of a light's picture, without its place.
Transform rotation_of(const Transform& to_world, const PbrtParameters& parameters, PbrtContext& context) {
  const double scale = similarity_scale(to_world);
  if (!(scale > 0)) {
    parameters.place().warn(context.warnings,
                            "the transform stretches the picture of this light; it is not turned at all");
    return {};
  }
  Transform rotation = Transform::scaling(1 / scale, 1 / scale, 1 / scale) * to_world;
  for (auto& row : rotation.m) row[3] = 0;
  return rotation;
}

/// The picture that a light names; nothing where it names none, or, with a warning, where it cannot be used.
std::shared_ptr<const Image> picture_of(const PbrtParameters& parameters, PbrtContext& context) {
  const std::string name = parameters.text("filename", "");
  if (name.empty()) return nullptr;
  const PbrtPlace& place = parameters.find("filename")->place;
  try {
    if (!context.files.is_disk()) throw Error(name + ": pictures are read from disk alone");
    const std::string path = context.files.path(place, name);
    context.options.add_file(path);
    LoadedEnvironment loaded = load_environment(path);
    if (!loaded.warning.empty()) place.warn(context.warnings, loaded.warning);
    if (!loaded.fault.empty()) place.warn(context.warnings, loaded.fault + "; such pixels are black");
    return std::make_shared<const Image>(std::move(loaded.map));
  } catch (const Error& error) {
    place.warn(context.warnings,
               fmt::format("{}; the light is as bright in all of its directions", error.what()));
    return nullptr;
  }
}

/// The picture that an area light names, if it names one: an ordinary one, of colors that are not negative.
std::shared_ptr<const Image> emission_of(const PbrtParameters& parameters, PbrtContext& context) {
  const std::string name = parameters.text("filename", "");
  if (name.empty()) return nullptr;
  const PbrtPlace& place = parameters.find("filename")->place;
  if (const PbrtParameter* color = parameters.find("L"))
    color->place.fail("an area light has a color \"L\" or a picture \"filename\", not both");
  const std::string path = context.files.is_disk() ? context.files.path(place, name) : "";
  context.options.add_file(path);
  const LoadedTexture loaded = load_texture(path, {});
  if (!loaded.warning.empty()) place.warn(context.warnings, loaded.warning);
  auto picture = std::make_shared<Image>(loaded.image->image(0));
  std::size_t negative = 0;
  for (Rgb& pixel : picture->pixels) {
    negative += std::min({pixel.r, pixel.g, pixel.b}) < 0 ? 1 : 0;
    pixel = at_least_zero(pixel);
  }
  if (negative > 0)
    place.warn(context.warnings,
               fmt::format("{} of the picture's {} pixels are below 0 in a channel, which emits nothing",
                           negative, picture->pixels.size()));
  return picture;
}

std::shared_ptr<const Image> one_pixel(const Rgb& value) {
  auto map = std::make_shared<Image>(1, 1);
  map->at(0, 0) = value;
  return map;
}

MapLayout layout_of(const Image& map) {
  return map.width == map.height ? MapLayout::equal_area : MapLayout::latitude_longitude;
}

/// From a picture's axes as core/light.h has them to the light's. Latitude and longitude are pbrt-v3's,
/// around +z: a column is the angle from +x towards +y, in turns.
Transform axes_of(MapLayout layout) {
  if (layout == MapLayout::equal_area) return {};
  return {{{-1, 0, 0, 0}, {0, 0, 1, 0}, {0, 1, 0, 0}}};
}

std::optional<LightSource> read_infinite(const PbrtParameters& parameters, const Transform& to_world,
                                         PbrtContext& context) {
  if (const PbrtParameter* portal = parameters.find("portal"))
    portal->place.warn(context.warnings, "\"portal\" is left out: light comes from all around");
  if (const PbrtParameter* color = parameters.find("L"); color && !parameters.text("filename", "").empty())
    color->place.fail("an infinite light has a color \"L\" or a picture \"filename\", not both");
  const Rgb radiance = scaled_color(parameters, "L", context);
  if (const auto map = picture_of(parameters, context)) {
    const MapLayout layout = layout_of(*map);
    const auto sum = [&] { return illuminance_sum(*map, layout, axes_of(layout)); };
    return EnvironmentLight{map, layout, rotation_of(to_world, parameters, context) * axes_of(layout),
                            with_strength_of(radiance, "illuminance", sum, parameters)};
  }
  return EnvironmentLight{one_pixel(with_strength(radiance, "illuminance", pi_double, parameters))};
}

/// The light's y axis is the picture's z axis.
std::optional<LightSource> read_goniometric(const PbrtParameters& parameters, const Transform& to_world,
                                            PbrtContext& context) {
  const auto map = picture_of(parameters, context);
  if (!parameters.find("filename"))
    parameters.place().warn(context.warnings,
                            "this goniometric light names no picture; it shines alike in all directions");
  if (!map) return read_point(parameters, to_world, context);
  auto grey = std::make_shared<Image>(*map);
  for (Rgb& pixel : grey->pixels) {
    const float mean = (pixel.r + pixel.g + pixel.b) / 3;
    pixel = {mean, mean, mean};
  }
  const Transform swap{{{1, 0, 0, 0}, {0, 0, 1, 0}, {0, 1, 0, 0}}};
  const MapLayout layout = layout_of(*grey);
  const auto sum = [&] { return sphere_sum(*grey, layout); };
  const Rgb intensity = with_strength_of(scaled_color(parameters, "I", context), "power", sum, parameters);
  return GoniometricLight{to_world.point({0, 0, 0}), intensity, grey, layout,
                          rotation_of(to_world, parameters, context) * swap * axes_of(layout)};
}

std::optional<LightSource> read_projection(const PbrtParameters& parameters, const Transform& to_world,
                                           PbrtContext& context) {
  const double fov = double(parameters.real("fov", 90, {1e-3, 179.9}));
  if (parameters.text("filename", "").empty())
    parameters.place().fail("a projection light needs its picture, \"string filename\"");
  auto picture = picture_of(parameters, context);
  if (!picture) picture = one_pixel(white);
  const Transform turn = rotation_of(to_world, parameters, context);
  const double half = tan_radians(fov * radians_per_degree / 2);
  const double aspect = double(picture->width) / double(picture->height);
  const double half_width = half * std::max(aspect, 1.0), half_height = half * std::max(1 / aspect, 1.0);
  const auto sum = [&] { return frame_sum(*picture, half_width, half_height); };
  const Rgb strength =
      with_strength_of(white * parameters.real("scale", 1, scales), "power", sum, parameters);
  return ProjectionLight{to_world.point({0, 0, 0}),
                         normalize(turn.vector({1, 0, 0})),
                         normalize(turn.vector({0, 1, 0})),
                         normalize(turn.vector({0, 0, 1})),
                         float(half_width),
                         float(half_height),
                         strength,
                         picture};
}

struct LightReader {
  std::string_view type;
  std::optional<LightSource> (*read)(const PbrtParameters&, const Transform&, PbrtContext&);
};
constexpr std::array<LightReader, 6> light_readers{{{"point", read_point},
                                                    {"spot", read_spot},
                                                    {"distant", read_distant},
                                                    {"infinite", read_infinite},
                                                    {"goniometric", read_goniometric},
                                                    {"projection", read_projection}}};

Rgb* strength(LightSource& light) {
  if (auto* mesh = std::get_if<MeshLight>(&light)) return &mesh->radiance;
  if (auto* sphere = std::get_if<SphereLight>(&light)) return &sphere->radiance;
  if (auto* point = std::get_if<PointLight>(&light)) return &point->intensity;
  if (auto* spot = std::get_if<SpotLight>(&light)) return &spot->intensity;
  if (auto* directional = std::get_if<DirectionalLight>(&light)) return &directional->irradiance;
  if (auto* environment = std::get_if<EnvironmentLight>(&light)) return &environment->scale;
  if (auto* goniometric = std::get_if<GoniometricLight>(&light)) return &goniometric->intensity;
  if (auto* projection = std::get_if<ProjectionLight>(&light)) return &projection->intensity;
  return nullptr;
}

}  // namespace

Rgb PbrtAreaLight::radiance_of(double area, std::size_t pieces) const {
  const double mean = picture ? double(luminance(mean_of(*picture))) : 1;
  const double unit = (is_two_sided ? 2 : 1) * pi_double * area / double(pieces) * mean;
  return power > 0 && unit > 0 ? radiance * float(double(power) / unit) : radiance;
}

PbrtAreaLight read_area_light(const std::string& type, const PbrtParameters& parameters,
                              PbrtContext& context) {
  if (type != "diffuse")
    parameters.place().fail(fmt::format("there is no area light \"{}\"; valid is diffuse", type));
  PbrtAreaLight light;
  light.radiance = scaled_color(parameters, "L", context);
  light.power = parameters.real("power", -1, any_power);
  light.is_two_sided = parameters.flag("twosided", false);
  light.picture = emission_of(parameters, context);
  parameters.warn_of_unused(context.warnings);
  return light;
}

std::optional<LightSource> read_light(const std::string& type, const PbrtParameters& parameters,
                                      const Transform& to_world, PbrtContext& context) {
  const auto reader = std::find_if(light_readers.begin(), light_readers.end(),
                                   [&](const LightReader& r) { return r.type == type; });
  if (reader == light_readers.end()) {
    std::vector<std::string_view> names;
    for (const LightReader& each : light_readers) names.push_back(each.type);
    parameters.place().fail(fmt::format("there is no light \"{}\"; valid are {}", type, list_names(names)));
  }
  auto light = reader->read(parameters, to_world, context);
  parameters.warn_of_unused(context.warnings);
  return light;
}

void scale_light(LightSource& light, float factor) {
  if (Rgb* value = strength(light)) *value = *value * factor;
}

}  // namespace twinray
