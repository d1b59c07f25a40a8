// SPDX-License-Identifier: Apache-2.0
// What a picture's file has beside the pixels.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace twinray {

/// Names and values.
using ImageMetadata = std::vector<std::pair<std::string, std::string>>;

/// The value of that name; empty where there is none.
std::string value_of(const ImageMetadata& metadata, const std::string& name);
/// Sets the value of that name, in the place of an old one.
void set_value(ImageMetadata& metadata, const std::string& name, const std::string& value);

/// How a picture's whole frame saw the world, as OpenEXR's attributes have it: 4x4, row by row, for points
/// that are rows and stand before the matrix.
struct CameraMatrices {
  /// To the camera's right, up and forward.
  std::array<float, 16> world_to_camera;
  /// To the frame, (0, 0) at its top left and (1, 1) at its bottom right.
  /// None where no matrix says where a point is seen, as in a panorama.
  std::optional<std::array<float, 16>> world_to_ndc;
};

/// The whole frame of which a picture is a part, and where its left top pixel lies in it.
struct ImageFrame {
  int x = 0, y = 0;
  int width = 0, height = 0;                  ///< 0: the picture is the whole frame.
  std::optional<CameraMatrices> camera = {};  ///< Kept in an EXR, if it is known.
};

/// The metadata by which a picture without windows says of what frame it is a part: x, y, width and height.
inline constexpr const char* frame_key = "twinray:frame";
std::string frame_value(const ImageFrame& frame);
/// Of such a value; nothing where it is none.
std::optional<ImageFrame> frame_of_value(const std::string& value);

}  // namespace twinray
