// SPDX-License-Identifier: Apache-2.0
#include "io/display/display.h"

#include <cmath>

#include "core/elementary.h"
#include "io/display/agx.h"
#include "io/display/white_balance.h"
#include "io/pbrt/spectrum.h"
#include "io/picture/image_codec.h"

namespace twinray {
namespace {

/// Exposure and white balance in one.
ColorMatrix gain_of(const Display& display) {
  ColorMatrix gain{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  if (display.white_kelvin)
    gain = white_balance(blackbody_color(*display.white_kelvin));
  else if (display.daylight_kelvin)
    gain = white_balance(daylight_color(*display.daylight_kelvin));
  for (auto& row : gain)
    for (double& entry : row) entry *= exp2_of(display.exposure_stops);
  return gain;
}

template <typename Change>
void change(Image& image, const Change& of) {
  for (Rgb& pixel : image.pixels) pixel = of(pixel);
}

/// Colours of a view are encoded already.
ByteImage in_bytes(const Image& image) {
  ByteImage bytes{image.width, image.height, {}};
  bytes.bytes.reserve(3 * image.pixels.size());
  for (const Rgb& pixel : image.pixels)
    for (const float channel : {pixel.r, pixel.g, pixel.b})
      bytes.bytes.push_back(std::uint8_t(255 * std::fmin(1.0f, std::fmax(0.0f, channel)) + 0.5f));
  return bytes;
}

}  // namespace

ByteImage displayed(const Image& image, const Display& display) {
  if (display == Display{}) return encode_srgb(image);
  Image shown = image;
  if (display.exposure_stops != 0 || display.white_kelvin || display.daylight_kelvin)
    change(shown, [gain = gain_of(display)](const Rgb& pixel) { return transformed(gain, pixel); });
  if (!display.ocio_view.empty())
    return in_bytes(image_codec().viewed(shown, display.ocio_display, display.ocio_view));
  if (display.tone == Tone::agx)
    change(shown, [agx = Agx()](const Rgb& pixel) { return agx.displayed(pixel); });
  return encode_srgb(shown);
}

}  // namespace twinray
