// SPDX-License-Identifier: Apache-2.0
#include "io/camera_file.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>

#include "core/angle.h"
#include "core/elementary.h"
#include "core/error.h"
#include "core/geometry.h"
#include "io/diagnostic.h"
#include "io/number_list.h"

namespace twinray {
namespace {

/// Where the numbers of the file stand.
enum Field : std::size_t {
  horizontal_fov = 0,
  vertical_fov = 1,
  near_clip = 3,
  far_clip = 4,
  position = 5,
  rotation = 16,
  field_count = 30,
};

/// The columns of the rotation must be orthonormal up to the file's six digits.
constexpr float orthonormal_tolerance = 1e-3f;

constexpr std::size_t max_bytes = 65536;

class CameraText {
 public:
  CameraText(std::string text, const std::string& name) : path_(name), text_(std::move(text)) {
    if (text_.size() > max_bytes)
      throw Error(fmt::format("{}: more than {} bytes; a camera settings file has {} numbers", name,
                              max_bytes, +field_count));
    try {
      numbers_ = parse_doubles(text_);
    } catch (const NumberError& error) {
      throw error_at(place_of(path_, text_, error.offset), error.message);
    }
    if (numbers_.size() != field_count)
      throw Error(
          fmt::format("{}: {} numbers; a camera settings file has {}", name, numbers_.size(), +field_count));
  }

  float number(std::size_t field) const { return float(numbers_[field]); }
  Vec3 vector(std::size_t field, std::size_t step) const {
    return {number(field), number(field + step), number(field + 2 * step)};
  }
  /// Half the frame at distance 1, of a field of view in degrees.
  float tan_half(Field field) const {
    const double degrees = numbers_[field];
    if (!(degrees > 0 && degrees < 180)) throw wrong(field, "a field of view lies between 0 and 180 degrees");
    const auto half = float(tan_radians(degrees * (pi_double / 360)));
    if (!(half > 0 && std::isfinite(half)))
      throw wrong(field, "this field of view cannot be told from 0 or 180 degrees");
    return half;
  }
  Error wrong(Field field, const std::string& message) const {
    return error_at(place_of(path_, text_, token_offset(text_, field)), message);
  }

 private:
  std::string path_, text_;
  std::vector<double> numbers_;
};

/// The file's first bytes, one more than there may be.
std::string read(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) throw Error(path + ": there is no such file");
  std::ifstream file(path, std::ios::binary);
  std::string text(max_bytes + 1, '\0');
  file.read(text.data(), std::streamsize(text.size()));
  text.resize(std::size_t(file.gcount()));
  if (!file.eof() && !file) throw Error(fmt::format("{}: cannot be read", path));
  return text;
}

bool is_orthonormal(const Vec3& a, const Vec3& b, const Vec3& c) {
  const std::array<float, 6> off{dot(a, b),     dot(b, c),     dot(c, a),
                                 dot(a, a) - 1, dot(b, b) - 1, dot(c, c) - 1};
  for (const float value : off)
    if (!(std::fabs(value) <= orthonormal_tolerance)) return false;
  return true;
}

}  // namespace

Camera load_camera_file(const std::string& path, const Camera& scene_camera) {
  return parse_camera(read(path), path, scene_camera);
}

Camera parse_camera(std::string contents, const std::string& name, const Camera& scene_camera) {
  const CameraText text(std::move(contents), name);
  Camera camera = scene_camera;
  camera.projection = Projection::perspective;
  camera.frame_center = {0, 0};
  camera.tan_half_width = text.tan_half(horizontal_fov);
  camera.tan_half_height = text.tan_half(vertical_fov);
  camera.clip_near = text.number(near_clip);
  camera.clip_far = text.number(far_clip);
  if (!(camera.clip_near >= 0 && camera.clip_near < camera.clip_far))
    throw text.wrong(near_clip, "the clip distances must satisfy 0 <= near < far");
  camera.position = text.vector(position, 1);
  if (!(max_abs(camera.position) <= max_coordinate))
    throw text.wrong(position, fmt::format("the camera's position must lie within +-{:g}", max_coordinate));
  camera.right = text.vector(rotation, 3);
  camera.up = text.vector(rotation + 1, 3);
  camera.forward = -text.vector(rotation + 2, 3);
  if (!is_orthonormal(camera.right, camera.up, camera.forward))
    throw text.wrong(rotation, "the columns of the camera-to-world rotation are not orthonormal");
  return camera;
}

}  // namespace twinray
