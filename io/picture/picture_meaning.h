// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <string>

namespace twinray {

/// What the numbers of a PNG or JPEG are: colours, encoded as sRGB has it, or data such as a roughness, kept
/// as they stand. An EXR or HDR holds linear numbers, whatever they mean.
enum class PictureRole { color, data };

/// What of its channels a pixel is made of: its colour; or one number, as grey: its alpha, where that is not
/// 1 all over, else the mean of its colour; or that of one channel (1 where there is no alpha); or the mean
/// of its colour whatever its alpha is.
enum class PictureChannels { color, number, red, green, blue, alpha, brightness };
inline constexpr PictureChannels last_channels = PictureChannels::brightness;

/// "color", "number", "red", ...
constexpr const char* channels_word(PictureChannels channels) {
  constexpr const char* words[] = {"color", "number", "red", "green", "blue", "alpha", "brightness"};
  return words[int(channels)];
}

/// What a texture makes of a picture's numbers.
struct PictureMeaning {
  PictureRole role = PictureRole::color;
  PictureChannels channels = PictureChannels::color;

  bool operator==(const PictureMeaning&) const = default;
};

/// A picture that a texture of a scene names.
struct PictureUse {
  std::string path;
  PictureMeaning meaning;
};

/// The largest picture of a texture: with its mip-map a gigabyte.
inline constexpr std::int64_t most_texture_pixels = std::int64_t(1) << 26;

}  // namespace twinray
