// SPDX-License-Identifier: Apache-2.0
#include "io/picture/camera_matrices.h"

namespace twinray {
namespace {

using Matrix = std::array<double, 16>;

/// Points are rows: what multiplies x, y, z and 1 stands in a column for each coordinate that comes out.
void set_column(Matrix& matrix, std::size_t column, const Vec3& axis, double constant) {
  matrix[column] = axis.x;
  matrix[4 + column] = axis.y;
  matrix[8 + column] = axis.z;
  matrix[12 + column] = constant;
}

double depth_of(const Vec3& axis, const Vec3& point) {
  return double(axis.x) * point.x + double(axis.y) * point.y + double(axis.z) * point.z;
}

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix c{};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      for (std::size_t k = 0; k < 4; ++k) c[4 * i + j] += a[4 * i + k] * b[4 * k + j];
  return c;
}

/// Camera space -> the frame. A perspective camera divides by the depth z; the third coordinate, 1 - 1/z, is
/// there so that the matrix can be inverted.
Matrix camera_to_ndc(const Camera& camera) {
  const double x = 0.5 / camera.tan_half_width, y = -0.5 / camera.tan_half_height;
  const double middle_x = 0.5 - x * camera.frame_center.x, middle_y = 0.5 - y * camera.frame_center.y;
  if (camera.projection == Projection::orthographic)
    return {x, 0, 0, 0, 0, y, 0, 0, 0, 0, 1, 0, middle_x, middle_y, 0, 1};
  return {x, 0, 0, 0, 0, y, 0, 0, middle_x, middle_y, 1, 1, 0, 0, -1, 0};
}

std::array<float, 16> in_floats(const Matrix& matrix) {
  std::array<float, 16> floats;
  for (std::size_t i = 0; i < 16; ++i) floats[i] = float(matrix[i]);
  return floats;
}

}  // namespace

CameraMatrices camera_matrices(const Camera& camera) {
  Matrix world_to_camera{};
  set_column(world_to_camera, 0, camera.right, -depth_of(camera.right, camera.position));
  set_column(world_to_camera, 1, camera.up, -depth_of(camera.up, camera.position));
  set_column(world_to_camera, 2, camera.forward, -depth_of(camera.forward, camera.position));
  world_to_camera[15] = 1;
  CameraMatrices matrices{in_floats(world_to_camera), std::nullopt};
  if (!is_panorama(camera.projection))
    matrices.world_to_ndc = in_floats(product(world_to_camera, camera_to_ndc(camera)));
  return matrices;
}

}  // namespace twinray
