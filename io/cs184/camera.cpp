// SPDX-License-Identifier: Apache-2.0
#include "io/cs184/camera.h"

#include <cmath>

#include "core/elementary.h"
#include "io/camera_file.h"

namespace twinray {
namespace {

constexpr int usual_width = 800, usual_height = 600;
/// How far the program tilts a camera that looks straight down, in radians.
constexpr double least_tilt = 1e-5f;
constexpr double distance_by_diagonal = 1.5;

struct Direction {
  double x, y, z;
};

/// The unit vector from what is looked at to the camera, in polar form: (sine horizontal_x, cosine,
/// sine horizontal_z).
struct Polar {
  double sine, cosine, horizontal_x, horizontal_z;
};

Polar polar_of(const double (&direction)[3]) {
  const double x = direction[0], y = direction[1], z = direction[2];
  const double length = std::sqrt(x * x + y * y + z * z);
  if (!(length > 0) || !std::isfinite(length)) return {1, 0, 0, 1};
  const double horizontal = std::sqrt(x * x + z * z), cosine = y / length;
  Polar polar{std::sqrt((1 - cosine) * (1 + cosine)), cosine, 0, 1};
  if (horizontal > 0) polar.horizontal_x = x / horizontal, polar.horizontal_z = z / horizontal;
  if (cosine == 1) polar.sine = sin_radians(least_tilt), polar.cosine = cos_radians(least_tilt);
  return polar;
}

double diagonal(const Aabb& box) {
  const double x = double(box.upper.x) - box.lower.x, y = double(box.upper.y) - box.lower.y,
               z = double(box.upper.z) - box.lower.z;
  return std::sqrt(x * x + y * y + z * z);
}

Vec3 middle_plus(const Aabb& box, const Direction& offset) {
  if (box.is_empty()) return {float(offset.x), float(offset.y), float(offset.z)};
  const auto sum = [](float a, float b, double c) { return float(0.5 * (double(a) + b) + c); };
  return {sum(box.lower.x, box.upper.x, offset.x), sum(box.lower.y, box.upper.y, offset.y),
          sum(box.lower.z, box.upper.z, offset.z)};
}

}  // namespace

Camera cs184_camera(const Cs184View& view, const Aabb& box) {
  constexpr double aspect = double(usual_width) / usual_height;
  const Polar to = polar_of(view.direction);
  const double x = to.sine * to.horizontal_x, y = to.cosine, z = to.sine * to.horizontal_z;
  const double distance = distance_by_diagonal * (box.is_empty() ? 1 : diagonal(box));
  Camera camera;
  camera.position = middle_plus(box, {distance * x, distance * y, distance * z});
  camera.right = {float(to.horizontal_z), 0, float(-to.horizontal_x)};
  camera.up = {float(-y * to.horizontal_x), float(to.sine), float(-y * to.horizontal_z)};
  camera.forward = {float(-x), float(-y), float(-z)};
  camera.tan_half_width = float(std::max(view.tan_half_width, view.tan_half_height * aspect));
  camera.tan_half_height = float(std::max(view.tan_half_height, view.tan_half_width / aspect));
  camera.clip_near = view.clip_near;
  camera.clip_far = view.clip_far;
  camera.clips_by_distance = true;
  return camera;
}

Camera cs184_frame(const Camera& camera, int width, int height) {
  Camera framed = camera;
  const double half_pixel = double(camera.tan_half_height) / usual_height;
  framed.tan_half_width = float(width * half_pixel);
  framed.tan_half_height = float(height * half_pixel);
  return framed;
}

Camera load_cs184_camera_file(const std::string& path, const Camera& scene_camera) {
  Camera camera = load_camera_file(path, scene_camera);
  camera.clips_by_distance = true;
  camera.is_stretched = true;
  return camera;
}

}  // namespace twinray
