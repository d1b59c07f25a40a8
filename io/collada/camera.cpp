// SPDX-License-Identifier: Apache-2.0
#include "io/collada/camera.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/angle.h"
#include "core/elementary.h"
#include "core/geometry.h"
#include "io/camera_axes.h"

namespace twinray {
namespace {

/// Where a file leaves one side to the image, its tangent is this part of the other one's: below that of any
/// image, so that fit_frame() widens it to the image's shape.
constexpr double open_side = 0x1p-20;

double tan_half_angle(const XmlElement& angle) {
  return tan_radians(number_in(angle, 1e-3, 179.9) * radians_per_degree / 2);
}

double half_magnification(const XmlElement& element) { return number_in(element, 1e-12, max_coordinate); }

/// How a kind of lens gives half its frame: a number for its width, one for its height.
struct Lens {
  const char *x, *y, *what;
  double (*half)(const XmlElement&);
};
constexpr Lens perspective_lens{"xfov", "yfov", ", in degrees", tan_half_angle},
    orthographic_lens{"xmag", "ymag", ", half the frame in scene units", half_magnification};

/// A height is kept whatever the image's shape, as Khronos's conformance suite has it; an <aspect_ratio>
/// beside it cannot change that.
void read_field(const XmlElement& element, const Lens& lens, Camera& camera, ColladaDocument& document) {
  const auto x = element.child(lens.x), y = element.child(lens.y), aspect = element.child("aspect_ratio");
  if (!x && !y)
    element.fail(fmt::format("<{}> needs <{}>, <{}> or both{}", element.name(), lens.x, lens.y, lens.what));
  const double ratio = aspect ? number_in(*aspect, 1e-4, 1e4) : 0;
  double width = x ? lens.half(*x) : 0, height = y ? lens.half(*y) : 0;
  if (x && y && aspect)
    document.warn(
        *aspect, fmt::format("<aspect_ratio> beside both <{}> and <{}> says too much; it is left out", lens.x,
                             lens.y));
  if (!y) height = aspect ? width / ratio : width * open_side;
  if (!x) width = height * open_side;
  camera.tan_half_width = float(width);
  camera.tan_half_height = float(height);
}

void read_clip(const XmlElement& lens, double unit, Camera& camera) {
  constexpr double most = 1e30;
  if (const auto near = lens.child("znear")) camera.clip_near = float(unit * number_in(*near, 0, most));
  if (const auto far = lens.child("zfar")) camera.clip_far = float(unit * number_in(*far, 0, most));
  if (!(camera.clip_near < camera.clip_far))
    lens.fail(fmt::format("<znear> is {} and <zfar> {}; znear must be the smaller one", camera.clip_near,
                          camera.clip_far));
}

/// Where a flat transform leaves no up (as in CS184's CBgems.dae), a warning says so.
void orient(const XmlElement& instance, const Transform& t, Camera& camera, ColladaDocument& document) {
  const CameraAxes axes = camera_axes(t);
  if (!axes.fault.empty()) instance.fail(axes.fault);
  if (axes.is_up_made)
    document.warn(
        instance,
        "the transform of this camera's node flattens its up direction; it is made of the other two");
  camera.right = axes.right, camera.up = axes.up, camera.forward = axes.forward;
}

XmlElement perspective_of(const XmlElement& camera) {
  const XmlElement common = camera.required_child("optics").required_child("technique_common");
  if (const auto other = common.child("orthographic"))
    other->fail("CS184's program has no orthographic cameras; valid is <perspective>");
  return common.required_child("perspective");
}

/// A frame in scene units is scaled as the node's axes are; where they are flat, not at all.
void scale_frame(const Transform& to_world, Camera& camera) {
  camera.tan_half_width *= float(frame_scale(to_world, 0));
  camera.tan_half_height *= float(frame_scale(to_world, 1));
}

/// Blender's exporter says how far the lens is shifted, to the right and up, in parts of the frame's longer
/// side.
void read_shift(const XmlElement& element, Camera& camera) {
  constexpr double most = 10;
  const float longer_side = 2 * std::max(camera.tan_half_width, camera.tan_half_height);
  for (const XmlElement& extra : element.children("extra"))
    for (const XmlElement& technique : extra.children("technique")) {
      if (technique.attribute("profile") != "blender") continue;
      if (const auto x = technique.child("shiftx"))
        camera.frame_center.x = longer_side * float(number_in(*x, -most, most));
      if (const auto y = technique.child("shifty"))
        camera.frame_center.y = longer_side * float(number_in(*y, -most, most));
    }
}

}  // namespace

Camera read_camera(const XmlElement& element, const XmlElement& instance, const Transform& to_world,
                   double unit, ColladaDocument& document) {
  const XmlElement common = element.required_child("optics").required_child("technique_common");
  const auto parallel = common.child("orthographic");
  const XmlElement lens = parallel ? *parallel : common.required_child("perspective");
  Camera camera;
  if (parallel) camera.projection = Projection::orthographic;
  read_field(lens, parallel ? orthographic_lens : perspective_lens, camera, document);
  if (parallel) scale_frame(to_world, camera);
  read_shift(element, camera);
  if (document.options().clip_as_file) read_clip(lens, unit, camera);
  orient(instance, to_world, camera, document);
  camera.position = to_world.point({0, 0, 0});
  if (!is_finite(camera.position) || max_abs(camera.position) > max_coordinate)
    instance.fail("the transform of this camera's node puts it too far away");
  return camera;
}

Cs184View read_cs184_view(const XmlElement& element, const XmlElement& instance, const Transform& to_world,
                          ColladaDocument& document) {
  const XmlElement lens = perspective_of(element);
  const auto xfov = lens.child("xfov"), yfov = lens.child("yfov"), aspect = lens.child("aspect_ratio");
  if (!xfov && !yfov) lens.fail("<perspective> needs <xfov>, <yfov> or both, in degrees");
  Cs184View view;
  if (xfov) view.tan_half_width = tan_half_angle(*xfov);
  view.tan_half_height = yfov     ? tan_half_angle(*yfov)
                         : aspect ? view.tan_half_width / number_in(*aspect, 1e-4, 1e4)
                                  : view.tan_half_width * open_side;
  Camera clip;
  clip.clip_near = 0.001f;
  clip.clip_far = 1000;
  read_clip(lens, 1, clip);
  view.clip_near = clip.clip_near;
  view.clip_far = clip.clip_far;
  double length_squared = 0;
  for (int row = 0; row < 3; ++row) {
    view.direction[row] = to_world.m[row][3] - to_world.m[row][2];
    length_squared += view.direction[row] * view.direction[row];
  }
  if (!(length_squared > 0) || !std::isfinite(length_squared))
    document.warn(
        instance,
        "CS184's program looks from the side of the point one unit in front of the camera, and that is "
        "the origin; the scene is seen from +z");
  return view;
}

}  // namespace twinray
