// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/camera.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>

#include "core/angle.h"
#include "core/elementary.h"
#include "core/geometry.h"
#include "io/diagnostic.h"
#include "io/pbrt/transform.h"
#include "io/pbrt/version_three.h"

namespace twinray {
namespace {

constexpr int default_width = 1280, default_height = 720, default_samples = 16, default_depth = 5;
constexpr int most_depth = 100, most_side = 65536, most_samples = 1 << 20;

void read_window(const PbrtParameters& parameters, PbrtCamera& camera) {
  const std::span<const float> window = parameters.reals("screenwindow");
  if (window.empty()) return;
  const PbrtPlace& place = parameters.find("screenwindow")->place;
  if (window.size() != 4) place.fail("\"screenwindow\" needs four numbers: x from and to, y from and to");
  if (!(window[0] < window[1]) || !(window[2] < window[3]))
    place.fail(
        fmt::format("\"screenwindow\" goes from {:g} to {:g} in x and from {:g} to {:g} in y; valid is "
                    "from the smaller to the larger number",
                    window[0], window[1], window[2], window[3]));
  std::copy(window.begin(), window.end(), camera.window.begin());
  camera.has_window = true;
}

double picture_aspect(const RenderDefaults& film) {
  return film.resolution ? double(film.resolution->width) / film.resolution->height : 1;
}

/// Half of the frame, at distance 1 or in scene units; what `shorter` is of its shorter side.
void set_frame(const PbrtCamera& camera, const RenderDefaults& film, double shorter, Camera& placed) {
  const double picture = picture_aspect(film);
  const double aspect = camera.frame_aspect > 0 ? double(camera.frame_aspect) : picture;
  double x = aspect > 1 ? aspect : 1, y = aspect > 1 ? 1 : 1 / aspect;
  if (camera.has_window) {
    x = double(camera.window[1] - camera.window[0]) / 2;
    y = double(camera.window[3] - camera.window[2]) / 2;
    placed.frame_center = {float(shorter * (double(camera.window[0]) + camera.window[1]) / 2),
                           float(shorter * (double(camera.window[2]) + camera.window[3]) / 2)};
  }
  placed.tan_half_width = float(shorter * x);
  placed.tan_half_height = float(shorter * y);
}

Vec3 unit_column(const Transform& t, int column) {
  return normalize(Vec3{float(t.m[0][column]), float(t.m[1][column]), float(t.m[2][column])});
}

/// The axes of a camera that is turned, mirrored or scaled, made orthonormal. A scale along one of them
/// stretches the frame.
void set_axes(const Transform& to_world, const PbrtPlace& place, Camera& placed, PbrtContext& context) {
  const Vec3 forward = unit_column(to_world, 2), right = unit_column(to_world, 0),
             up = unit_column(to_world, 1);
  placed.forward = forward;
  placed.right = normalize(right - forward * dot(right, forward));
  const Vec3 above = cross(placed.forward, placed.right);
  placed.up = dot(above, up) < 0 ? -above : above;
  if (!is_finite(placed.right)) place.fail("the transform of this camera leaves it no direction");
  constexpr float tolerance = 1e-3f;
  if (dot(placed.right, right) < 1 - tolerance || dot(placed.up, up) < 1 - tolerance)
    place.warn(context.warnings, "the transform skews this camera; its axes are made perpendicular");
}

/// x, y, width and height of the part from..to of the resolution, as whole pixels.
std::optional<std::array<int, 4>> pixels_of(const std::array<double, 4>& from_to,
                                            const RenderDefaults::Resolution& size) {
  const auto pixel = [](double at, int most) { return int(std::clamp(std::ceil(at), 0.0, double(most))); };
  const int x0 = pixel(std::min(from_to[0], from_to[1]), size.width);
  const int x1 = pixel(std::max(from_to[0], from_to[1]), size.width);
  const int y0 = pixel(std::min(from_to[2], from_to[3]), size.height);
  const int y1 = pixel(std::max(from_to[2], from_to[3]), size.height);
  if (x0 >= x1 || y0 >= y1) return std::nullopt;
  return std::array{x0, y0, x1 - x0, y1 - y0};
}

void read_crop(const PbrtParameters& parameters, RenderDefaults& defaults, WarningList& warnings) {
  const std::span<const float> part = parameters.reals("cropwindow");
  const std::span<const std::int32_t> bounds = parameters.integers("pixelbounds");
  if (part.empty() && bounds.empty()) return;
  const char* name = part.empty() ? "pixelbounds" : "cropwindow";
  if (!part.empty() && !bounds.empty())
    parameters.find("pixelbounds")
        ->place.warn(warnings, "\"pixelbounds\" are not used beside a \"cropwindow\"");
  const RenderDefaults::Resolution& size = *defaults.resolution;
  const bool is_right = part.empty() ? bounds.size() == 4 : part.size() == 4;
  // As floats: 0.1 of 100 pixels are 10, though the nearest float to 0.1 is a little more.
  std::array<double, 4> edges{};
  for (std::size_t i = 0; i < 4 && is_right; ++i)
    edges[i] = part.empty() ? double(bounds[i]) : double(float(i < 2 ? size.width : size.height) * part[i]);
  if (is_right && (std::min(edges[0], edges[2]) < 0 || edges[1] > size.width || edges[3] > size.height ||
                   edges[0] > edges[1] || edges[2] > edges[3]))
    parameters.find(name)->place.warn(
        warnings,
        fmt::format("\"{}\" reaches beyond the film, or ends before it begins: the part of the film "
                    "between its numbers is rendered",
                    name));
  if (is_right) defaults.crop = pixels_of(edges, size);
  if (!defaults.crop)
    parameters.find(name)->place.fail(
        fmt::format("\"{}\" needs four numbers, x from and to, y from and to, with pixels between", name));
}

Projection projection_of(const std::string& type, const PbrtParameters& parameters) {
  if (type == "perspective" || type == "realistic") return Projection::perspective;
  if (type == "orthographic") return Projection::orthographic;
  if (type != "spherical")
    parameters.place().fail(fmt::format(
        "there is no camera \"{}\"; valid are perspective, orthographic, realistic and spherical", type));
  const std::string mapping = parameters.text("mapping", "equalarea");
  if (mapping == "equalarea") return Projection::equal_area;
  if (mapping == "equirectangular") return Projection::latitude_longitude;
  parameters.find("mapping")->place.fail(
      fmt::format("there is no mapping \"{}\"; valid are equalarea and equirectangular", mapping));
}

/// A panorama of the sphere as pbrt has it: mirrored, since its space is left-handed.
Camera placed_panorama(const Camera& axes, Projection projection) {
  Camera placed = with_panorama(axes, projection, 0);
  if (projection == Projection::latitude_longitude) {
    placed.forward = -axes.right;
    placed.right = -axes.forward;
  }
  return placed;
}

}  // namespace

/// In seconds: more than any exposure takes.
constexpr NumberRange shutter_times{-1e6, 1e6};

PbrtCamera read_camera(const std::string& type, const PbrtParameters& parameters, PbrtContext& context) {
  PbrtCamera camera;
  camera.is_given = true;
  camera.projection = projection_of(type, parameters);
  camera.place = parameters.place();
  if (type == "realistic") camera.lens = read_lens(parameters, context);
  if (camera.projection == Projection::perspective && camera.lens.empty())
    camera.fov_degrees = parameters.real("fov", 90, {1e-3, 179.9});
  if (camera.lens.empty()) {
    camera.frame_aspect = parameters.real("frameaspectratio", 0, {1e-4, 1e4});
    read_window(parameters, camera);
  }
  if (!is_panorama(camera.projection) && camera.lens.empty()) {
    camera.lens_radius = parameters.real("lensradius", 0, {0, 1e12});
    camera.focal_distance = parameters.real("focaldistance", 1e6f, {1e-12, 1e30});
  }
  const float open = parameters.real("shutteropen", 0, shutter_times),
              close = parameters.real("shutterclose", 1, shutter_times);
  camera.shutter = {open, close};
  if (!(open < close))
    camera.place.fail(
        "the shutter closes when it opens, or before: no light gets in; shutteropen must be less "
        "than shutterclose");
  parameters.warn_of_unused(context.warnings);
  return camera;
}

namespace {

/// The light that is white. 0: the color space's.
void read_white(const PbrtParameters& parameters, RenderDefaults& defaults, PbrtContext& context) {
  const auto kelvin = double(parameters.real("whitebalance", 0));
  if (kelvin == 0) return;
  if (!(kelvin >= least_white_kelvin && kelvin <= most_white_kelvin)) {
    parameters.find("whitebalance")
        ->place.warn(context.warnings,
                     fmt::format("a white balance of {:g} K is not rendered; valid are {:g} to {:g}", kelvin,
                                 least_white_kelvin, most_white_kelvin));
    return;
  }
  defaults.daylight_kelvin = kelvin;
  context.notes.push_back(
      fmt::format("in pictures of 8 bits daylight of {:g} K is white, as the film says; --white-balance is "
                  "another one, and floats keep the light",
                  kelvin));
}

}  // namespace

PbrtFilm read_film(const std::string& type, const PbrtParameters& parameters, PbrtContext& context) {
  if (type != "rgb" && type != "gbuffer" && type != "spectral")
    parameters.place().fail(fmt::format("there is no film \"{}\"; valid are rgb, gbuffer and spectral{}",
                                        type, version_three_hint(type)));
  if (type != "rgb")
    parameters.place().warn(context.warnings,
                            fmt::format("a {} film is not rendered: the picture is rgb", type));
  PbrtFilm film;
  film.defaults.resolution = {parameters.integer("xresolution", default_width, {1, most_side}),
                              parameters.integer("yresolution", default_height, {1, most_side})};
  read_crop(parameters, film.defaults, context.warnings);
  film.iso = parameters.real("iso", 100, {1e-6, 1e9});
  film.diagonal = parameters.real("diagonal", film.diagonal, {1e-3, 1e6});
  if (const std::string sensor = parameters.text("sensor", "cie1931"); sensor != "cie1931")
    parameters.find("sensor")->place.warn(
        context.warnings,
        fmt::format("the sensor \"{}\" is not rendered: colors are those of cie1931", sensor));
  read_white(parameters, film.defaults, context);
  for (const char* unused :
       {"filename", "savefp16", "coordinatesystem", "nbuckets", "lambdamin", "lambdamax"})
    parameters.find(unused);  // about files, sensors of other cameras and pbrt's own estimates
  if (std::isfinite(parameters.real("maxcomponentvalue", Aabb::infinity)))
    parameters.find("maxcomponentvalue")
        ->place.warn(context.warnings, "\"maxcomponentvalue\" is not heeded; --clamp limits indirect light");
  parameters.warn_of_unused(context.warnings);
  return film;
}

namespace {

constexpr std::string_view samplers[] = {"halton", "independent", "paddedsobol", "pmj02bn",
                                         "sobol",  "stratified",  "zsobol"};
constexpr std::string_view integrators[] = {
    "ambientocclusion", "bdpt",       "function",      "lightpath", "mlt",    "path",
    "randomwalk",       "simplepath", "simplevolpath", "sppm",      "volpath"};

/// Of what pbrt refuses, and what changes nothing here.
void warn_of_unknown(const char* what, const std::string& type, std::span<const std::string_view> known,
                     const PbrtParameters& parameters, PbrtContext& context) {
  if (std::find(known.begin(), known.end(), type) == known.end())
    parameters.place().warn(
        context.warnings, fmt::format("there is no {} \"{}\"; valid are {}", what, type, list_names(known)));
}

}  // namespace

void read_sampler(const std::string& type, const PbrtParameters& parameters, RenderDefaults& defaults,
                  PbrtContext& context) {
  warn_of_unknown("sampler", type, samplers, parameters, context);
  const bool is_stratified = type == "stratified";
  const int count = is_stratified ? parameters.integer("xsamples", 4, {1, 1024}) *
                                        parameters.integer("ysamples", 4, {1, 1024})
                                  : parameters.integer("pixelsamples", default_samples, {1, most_samples});
  defaults.samples = std::uint32_t(count);
  for (const char* unused : {"seed", "randomization", "jitter"}) parameters.find(unused);
  parameters.warn_of_unused(context.warnings);
}

void read_integrator(const std::string& type, const PbrtParameters& parameters, RenderDefaults& defaults,
                     PbrtContext& context) {
  warn_of_unknown("integrator", type, integrators, parameters, context);
  defaults.max_depth = std::min(parameters.integer("maxdepth", default_depth, {0, 1e9}), most_depth);
  for (const char* unused :
       {"lightsampler", "samplelights", "samplebsdf", "visualizestrategies", "visualizeweights",
        "photonsperiteration", "radius", "seed", "bootstrapsamples", "chains", "mutationsperpixel",
        "largestepprobability", "sigma", "cossample", "maxdistance"})
    parameters.find(unused);
  if (parameters.flag("regularize", false))
    parameters.find("regularize")
        ->place.warn(context.warnings, "\"regularize\" is an option here: --regularize");
  if (type == "ambientocclusion")
    parameters.place().warn(context.warnings, "ambient occlusion is not rendered; this is a path tracer");
  else if (type != "path" && type != "volpath")
    context.notes.push_back(
        fmt::format("the integrator \"{}\" is not there; paths are traced from the camera", type));
  parameters.warn_of_unused(context.warnings);
}

namespace {

/// None for the one that is not rendered.
std::optional<FilterKind> filter_kind_of(const std::string& type, const PbrtPlace& place) {
  constexpr std::pair<const char*, FilterKind> kinds[] = {{"box", FilterKind::box},
                                                          {"triangle", FilterKind::triangle},
                                                          {"gaussian", FilterKind::gaussian},
                                                          {"mitchell", FilterKind::mitchell}};
  for (const auto& [name, kind] : kinds)
    if (type == name) return kind;
  if (type != "sinc")
    place.fail(fmt::format(
        "there is no pixel filter \"{}\"; valid are box, gaussian, mitchell, sinc and triangle", type));
  return std::nullopt;
}

float usual_pbrt_radius(FilterKind kind) {
  return kind == FilterKind::box ? 0.5f : kind == FilterKind::gaussian ? 1.5f : 2;
}

}  // namespace

void read_filter(const std::string& type, const PbrtParameters& parameters, RenderDefaults& defaults,
                 PbrtContext& context) {
  const auto kind = filter_kind_of(type, parameters.place());
  if (!kind) {
    parameters.place().warn(context.warnings, "the sinc filter is not rendered");
    for (const char* unused : {"xradius", "yradius", "tau"}) parameters.find(unused);
  } else {
    const float usual = usual_pbrt_radius(*kind);
    constexpr NumberRange radii{least_filter_radius, most_filter_radius};
    PixelFilter filter{.kind = *kind};
    filter.radius.x = parameters.real("xradius", usual, radii);
    filter.radius.y = parameters.real("yradius", usual, radii);
    if (*kind == FilterKind::gaussian) filter.sigma = parameters.real("sigma", 0.5f, {1e-2, 1e3});
    if (*kind == FilterKind::mitchell) {
      filter.b = parameters.real("B", filter.b, {0, 1});
      filter.c = parameters.real("C", filter.c, {0, 1});
    }
    defaults.filter = filter;
  }
  parameters.warn_of_unused(context.warnings);
}

namespace {

/// The frame and the lens, in units of the world.
void set_lens(const PbrtCamera& camera, const RenderDefaults& film, const Transform& to_world,
              Camera& placed) {
  const bool is_parallel = camera.projection == Projection::orthographic;
  set_frame(camera, film, is_parallel ? 1 : tan_radians(double(camera.fov_degrees) * radians_per_degree / 2),
            placed);
  const double depth = axis_length(to_world, 2), unit = is_parallel ? 1 : depth;
  const auto width = float(axis_length(to_world, 0) / unit), height = float(axis_length(to_world, 1) / unit);
  placed.tan_half_width *= width;
  placed.tan_half_height *= height;
  const double picture = picture_aspect(film);
  const double frame = double(placed.tan_half_width) / placed.tan_half_height;
  placed.is_stretched = film.resolution && std::fabs(frame - picture) > 1e-4 * picture;
  placed.frame_center = {placed.frame_center.x * width, placed.frame_center.y * height};
  placed.lens_radius = camera.lens_radius * float(axis_length(to_world, 0));
  placed.focal_distance = camera.focal_distance * float(depth);
}

/// The lens system and its film, likewise.
void set_lens_system(const PbrtCamera& camera, const PbrtFilm& film, const Transform& to_world,
                     Camera& placed) {
  const double millimeter = axis_length(to_world, 2) / 1000, half_diagonal = double(film.diagonal) / 2;
  const double aspect = picture_aspect(film.defaults);
  try {
    placed.lenses = std::make_shared<const LensSystem>(scaled_lens(camera.lens, half_diagonal, millimeter));
  } catch (const Error& error) {
    camera.place.fail(error.what());
  }
  const double half_height = half_diagonal * millimeter / std::sqrt(1 + aspect * aspect);
  placed.tan_half_height = float(half_height / placed.lenses->image_distance());
  placed.tan_half_width = float(half_height * aspect / placed.lenses->image_distance());
}

/// Whether the transform makes width and height equally large.
bool is_evenly_wide(const Transform& to_world) {
  const double width = axis_length(to_world, 0), height = axis_length(to_world, 1);
  return std::fabs(width - height) <= 1e-5 * width;
}

/// Whether it makes depth and height equally large.
bool is_as_deep(const Transform& to_world) {
  const double depth = axis_length(to_world, 2), height = axis_length(to_world, 1);
  return std::fabs(depth - height) <= 1e-5 * depth;
}

}  // namespace

Camera place_camera(const PbrtCamera& camera, const PbrtFilm& film, PbrtContext& context) {
  const std::optional<Transform>& to_world = camera.to_world;
  if (!to_world) camera.place.fail("the transform of this camera flattens what it sees");
  Camera placed;
  placed.projection = camera.projection;
  set_axes(*to_world, camera.place, placed, context);
  if (is_panorama(camera.projection))
    placed = placed_panorama(placed, camera.projection);
  else if (!camera.lens.empty())
    set_lens_system(camera, film, *to_world, placed);
  else
    set_lens(camera, film.defaults, *to_world, placed);
  if (placed.lens_radius > 0 && !is_evenly_wide(*to_world))
    camera.place.warn(context.warnings, "the camera's lens stays round, which its transform stretches");
  if (placed.lenses && !(is_evenly_wide(*to_world) && is_as_deep(*to_world)))
    camera.place.warn(context.warnings,
                      "the camera's transform scales its axes differently: its lens and film have the scale "
                      "of the view's axis");
  placed.position = to_world->point({0, 0, 0});
  if (!is_finite(placed.position) || max_abs(placed.position) > max_coordinate)
    camera.place.fail("the transform of this camera puts it too far away");
  return placed;
}

}  // namespace twinray
