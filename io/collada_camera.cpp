// SPDX-License-Identifier: Apache-2.0
#include "io/collada_camera.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/elementary.h"
#include "core/geometry.h"

namespace twinray {
namespace {

constexpr double radians_per_degree = 0.017453292519943295;
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
constexpr Lens perspective{"xfov", "yfov", ", in degrees", tan_half_angle},
    orthographic{"xmag", "ymag", ", half the frame in scene units", half_magnification};

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

struct Axis {
  double x, y, z;

  double length() const { return std::sqrt(x * x + y * y + z * z); }
  double dot(const Axis& b) const { return x * b.x + y * b.y + z * b.z; }
  Axis cross(const Axis& b) const { return {y * b.z - z * b.y, z * b.x - x * b.z, x * b.y - y * b.x}; }
  Axis minus(const Axis& b, double s) const { return {x - s * b.x, y - s * b.y, z - s * b.z}; }
  Axis unit() const { return {x / length(), y / length(), z / length()}; }
  Vec3 vec() const { return {float(x), float(y), float(z)}; }
};

/// Gram and Schmidt's way: the direction of view stays, then up. Where a flat transform leaves no up (as in
/// CS184's CBgems.dae) it is made of the other two.
void orient(const XmlElement& instance, const Transform& t, Camera& camera, ColladaDocument& document) {
  constexpr double flat = 1e-6;
  const auto column = [&](int c) { return Axis{t.m[0][c], t.m[1][c], t.m[2][c]}; };
  const Axis x = column(0), y = column(1), z = column(2);
  if (!(z.length() > 0) || !std::isfinite(x.length() + y.length() + z.length()))
    instance.fail("the transform of this camera's node gives it no direction: it flattens the z axis");
  const Axis back = z.unit();
  Axis up = y.minus(back, y.dot(back));
  Axis right = x.minus(back, x.dot(back));
  const bool has_up = up.length() > flat * y.length(), has_right = right.length() > flat * x.length();
  if (!has_up && !has_right) instance.fail("the transform of this camera's node leaves it no up direction");
  if (!has_up) {
    document.warn(
        instance,
        "the transform of this camera's node flattens its up direction; it is made of the other two");
    up = back.cross(right);
  }
  up = up.unit();
  const Axis across = up.cross(back);
  const double side = has_right && across.dot(right) < 0 ? -1 : 1;  // a mirrored camera stays mirrored
  camera.up = up.vec();
  camera.right = Axis{side * across.x, side * across.y, side * across.z}.vec();
  camera.forward = Axis{-back.x, -back.y, -back.z}.vec();
}

XmlElement perspective_of(const XmlElement& camera) {
  const XmlElement common = camera.required_child("optics").required_child("technique_common");
  if (const auto other = common.child("orthographic"))
    other->fail("CS184's program has no orthographic cameras; valid is <perspective>");
  return common.required_child("perspective");
}

/// A frame in scene units is scaled as the node's axes are; where they are flat, not at all.
void scale_frame(const Transform& to_world, Camera& camera) {
  const auto length_of = [&](int c) {
    const double length = Axis{to_world.m[0][c], to_world.m[1][c], to_world.m[2][c]}.length();
    return float(length > 0 ? length : 1);
  };
  camera.tan_half_width *= length_of(0);
  camera.tan_half_height *= length_of(1);
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
  read_field(lens, parallel ? orthographic : perspective, camera, document);
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

Camera default_camera(const Aabb& bounds) {
  constexpr double half_field = 20 * radians_per_degree;
  const Axis back = Axis{0.6, 0.5, 1}.unit();
  const Axis right = Axis{0, 1, 0}.cross(back).unit();
  Camera camera;
  camera.forward = Axis{-back.x, -back.y, -back.z}.vec();
  camera.right = right.vec();
  camera.up = back.cross(right).vec();
  camera.tan_half_width = camera.tan_half_height = float(tan_radians(half_field));
  camera.position = back.vec();
  return view_whole(camera, bounds);
}

}  // namespace twinray
