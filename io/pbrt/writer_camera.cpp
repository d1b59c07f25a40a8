// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/writer_camera.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/angle.h"
#include "core/elementary.h"
#include "io/output_file.h"
#include "io/pbrt/text.h"
#include "io/pbrt/transform.h"

namespace twinray {
namespace {

/// Of a fisheye, whose picture is written as a plane's.
constexpr float widest_tangent = 4;

/// From camera space, where x is to the right, y up and z along the view.
Transform to_world(const Vec3& right, const Vec3& up, const Vec3& forward, const Vec3& position) {
  Transform t;
  const Vec3 columns[4] = {right, up, forward, position};
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column) t.m[row][column] = double(columns[column][row]);
  return t;
}

/// A panorama's directions go around another axis there: io/pbrt/camera.cpp turns them the other way.
Transform frame_of(const Camera& camera) {
  if (camera.projection == Projection::latitude_longitude)
    return to_world(-camera.forward, camera.up, -camera.right, camera.position);
  return to_world(camera.right, camera.up, camera.forward, camera.position);
}

bool has_aspect(const Camera& camera, const RenderDefaults::Resolution& size) {
  constexpr double tolerance = 1e-5;
  const double picture = double(size.width) / size.height;
  const double frame = double(camera.tan_half_width) / double(camera.tan_half_height);
  return std::fabs(frame - picture) <= tolerance * picture;
}

/// The frame in units of `unit`: x from and to, y from and to.
std::string window(const Camera& camera, float unit) {
  const Vec2 c = camera.frame_center;
  return fmt::format(" \"float screenwindow\" [ {} {} {} {} ]", (c.x - camera.tan_half_width) / unit,
                     (c.x + camera.tan_half_width) / unit, (c.y - camera.tan_half_height) / unit,
                     (c.y + camera.tan_half_height) / unit);
}

std::string lens(const Camera& camera) {
  if (camera.lens_radius == 0) return "";
  return pbrt_real("lensradius", camera.lens_radius) + pbrt_real("focaldistance", camera.focal_distance);
}

/// "fov" is that of the shorter side, unless a window says more.
std::string perspective(const Camera& camera, const RenderDefaults::Resolution& size) {
  const float shorter = std::min(camera.tan_half_width, camera.tan_half_height);
  const double degrees = 2 * degrees_per_turn * atan2_turns(double(shorter), 1);
  // A window says more exactly how narrow or how wide others are.
  const bool is_usual = degrees >= 0.01 && degrees <= 179;
  const bool is_plain = is_usual && camera.frame_center == Vec2{0, 0} && has_aspect(camera, size);
  return "Camera \"perspective\"" + pbrt_real("fov", is_usual ? float(degrees) : 90) +
         (is_plain ? "" : window(camera, is_usual ? shorter : 1)) + lens(camera);
}

/// What sees within an angle becomes a plane that is as high, as far as it goes.
Camera flat(const Camera& fisheye) {
  Camera camera = fisheye;
  const auto tangent = [](float angle) {
    return angle < 1.3f ? std::min(float(tan_radians(double(angle))), widest_tangent) : widest_tangent;
  };
  camera.projection = Projection::perspective;
  const float ratio = fisheye.tan_half_width / fisheye.tan_half_height;
  const float least = tangent(std::min(fisheye.tan_half_width, fisheye.tan_half_height));
  camera.tan_half_width = least * std::max(ratio, 1.0f);
  camera.tan_half_height = least * std::max(1 / ratio, 1.0f);
  return camera;
}

/// How long one unit of a lens system's camera space is in the scene: 1, or as much as makes a film of other
/// than usual sizes one of 35 mm.
double lens_unit(const Camera& camera) {
  if (!camera.lenses) return 1;
  constexpr double usual = 0.035, least = 1e-3, most = 1;
  const double diagonal = 2 * camera.lenses->film_radius();
  return diagonal >= least && diagonal <= most ? 1 : diagonal / usual;
}

/// In the scene.
double film_diagonal(const Camera& camera) {
  const auto width = double(camera.tan_half_width), height = double(camera.tan_half_height);
  return 2 * camera.lenses->image_distance() * std::sqrt(width * width + height * height);
}

/// A lens file, by how many millimeters a unit of the scene is long.
std::string lens_text(const LensSystem& lens, double millimeters) {
  std::string text = "# curvature radius, thickness, index of refraction, aperture diameter, in mm\n";
  for (const LensSurface& s : lens.surfaces())
    text += fmt::format("{:.9g} {:.9g} {:.9g} {:.9g}\n", s.curvature_radius * millimeters,
                        s.thickness * millimeters, s.ior, 2 * s.aperture_radius * millimeters);
  return text;
}

/// pbrt moves the film to where the focus is. It makes all stops as wide as the camera says, or less.
std::string realistic(const Camera& camera, SceneOutput& output) {
  const LensSystem& lens = *camera.lenses;
  const double unit = lens_unit(camera), millimeters = 1000 / unit;
  double widest = 0;
  for (std::size_t i = 0; i < lens.surfaces().size(); ++i)
    if (is_stop(lens.surfaces(), i)) widest = std::max(widest, lens.surfaces()[i].aperture_radius);
  constexpr double farthest = 1e6;
  const double focus = std::min(lens.focus_distance() / unit, farthest);
  const auto write = [text = lens_text(lens, millimeters)](const std::string& path) {
    write_file(path, text);
  };
  return "Camera \"realistic\"" + pbrt_word("lensfile", output.add("-lens.dat", write)) +
         pbrt_real("focusdistance", float(focus)) +
         (widest > 0 ? pbrt_real("aperturediameter", float(2 * widest * millimeters)) : "");
}

std::string camera_text(const Camera& camera, const RenderDefaults::Resolution& size, SceneOutput& output) {
  if (camera.lenses) return realistic(camera, output);
  switch (camera.projection) {
    case Projection::orthographic:
      return "Camera \"orthographic\"" + window(camera, 1) + lens(camera);
    case Projection::latitude_longitude:
      return "Camera \"spherical\"" + pbrt_word("mapping", "equirectangular");
    case Projection::equal_area:
      return "Camera \"spherical\"" + pbrt_word("mapping", "equalarea");
    case Projection::fisheye:
      return perspective(flat(camera), size);
    default:
      return perspective(camera, size);
  }
}

void name_lens_losses(const Camera& camera, const RenderDefaults::Resolution& size, Losses& losses) {
  const LensSystem& lens = *camera.lenses;
  if (camera.frame_center != Vec2{0, 0})
    losses.add("the shift of the camera's frame is left out, for its lens has none in pbrt");
  if (!has_aspect(camera, size))
    losses.add("the camera's pixels become square, for its film has no others in pbrt");
  // Of two places at which the film is sharp pbrt takes the nearer one.
  if (lens.image_distance() > 2 * lens.focal_length() || !std::isfinite(lens.focus_distance()))
    losses.add("the camera's film is moved, for pbrt cannot have it where it is");
}

/// Whether a panorama's frame is not all that there is to be seen.
bool is_partial(const Camera& camera) {
  const Camera whole = with_panorama(camera, camera.projection, camera.tan_half_width);
  return camera.tan_half_width != whole.tan_half_width || camera.tan_half_height != whole.tan_half_height ||
         camera.frame_center != whole.frame_center;
}

void name_losses(const Camera& camera, const RenderDefaults::Resolution& size, Losses& losses) {
  const bool is_sphere =
      camera.projection == Projection::latitude_longitude || camera.projection == Projection::equal_area;
  if (is_sphere && is_partial(camera))
    losses.add("the camera's frame is all around, for pbrt's spherical cameras see no part of it");
  if (camera.projection == Projection::fisheye)
    losses.add("the fisheye camera is a perspective one, whose frame is as wide as far as a plane goes");
  if (camera.clip_near > 0 || std::isfinite(camera.clip_far))
    losses.add("the camera's clip distances are left out");
  if (camera.lenses) name_lens_losses(camera, size, losses);
  if (camera.lens_radius > 0 && camera.aperture_blades > 0)
    losses.add("the blades of the camera's lens are left out: it is round");
}

std::string film_text(const SceneToWrite& input, const Camera& camera, const std::string& path) {
  const RenderDefaults::Resolution& size = *input.picture.resolution;
  const std::string name = name_of_file(path);
  std::string text = "Film \"rgb\"" + pbrt_integer("xresolution", size.width) +
                     pbrt_integer("yresolution", size.height) +
                     pbrt_word("filename", name.substr(0, name.rfind('.')) + ".exr");
  if (camera.lenses) text += pbrt_real("diagonal", float(1000 / lens_unit(camera) * film_diagonal(camera)));
  if (input.picture.crop) {
    const auto& [x, y, width, height] = *input.picture.crop;
    text += fmt::format(" \"integer pixelbounds\" [ {} {} {} {} ]", x, x + width, y, y + height);
  }
  if (input.picture.daylight_kelvin) text += pbrt_real("whitebalance", float(*input.picture.daylight_kelvin));
  return text + "\n";
}

std::string filter(const PixelFilter& filter, Losses& losses) {
  const bool is_known = filter.kind != FilterKind::blackman_harris;
  if (!is_known) losses.add("the pixel filter blackman-harris is a Gaussian");
  std::string text = fmt::format("PixelFilter \"{}\"", is_known ? filter_name(filter.kind) : "gaussian") +
                     pbrt_real("xradius", filter.radius.x) + pbrt_real("yradius", filter.radius.y);
  if (filter.kind == FilterKind::gaussian) text += pbrt_real("sigma", filter.sigma);
  if (filter.kind == FilterKind::mitchell) text += pbrt_real("B", filter.b) + pbrt_real("C", filter.c);
  return text + "\n";
}

}  // namespace

std::string pbrt_view(const SceneToWrite& input, SceneOutput& output) {
  const RenderDefaults::Resolution& size = *input.picture.resolution;
  const Camera camera = fit_frame(input.scene.camera, size.width, size.height);
  name_losses(camera, size, output.losses);
  const auto from_world = inverse(frame_of(camera));
  const double meters = 1 / lens_unit(camera);
  std::string text =
      pbrt_transform(Transform::scaling(meters, meters, meters) * from_world.value_or(Transform{})) +
      camera_text(camera, size, output) + "\n";
  text += film_text(input, camera, output.path());
  if (input.picture.samples)
    text += "Sampler \"zsobol\"" + pbrt_integer("pixelsamples", int(*input.picture.samples)) + "\n";
  text += "Integrator \"volpath\"";
  if (input.picture.max_depth) text += pbrt_integer("maxdepth", *input.picture.max_depth);
  text += "\n";
  return input.picture.filter ? text + filter(*input.picture.filter, output.losses) : text;
}

}  // namespace twinray
