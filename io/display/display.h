// SPDX-License-Identifier: Apache-2.0
// What a display shows of linear colours: of pictures in formats of 8 bits. Those of floats keep the light.
#pragma once
#include <optional>
#include <string>

#include "core/image.h"
#include "io/render_defaults.h"

namespace twinray {

enum class Tone {
  srgb,  ///< As it is, up to 1.
  agx,   ///< As film does (io/display/agx.h).
};

struct Display {
  double exposure_stops = 0;  ///< All light times 2 to this power.
  /// The light of a black body of this temperature becomes white. Kelvin, from least_white_kelvin to
  /// most_white_kelvin.
  std::optional<double> white_kelvin;
  /// Where that is not said: daylight of this temperature (daylight_color()).
  std::optional<double> daylight_kelvin;
  Tone tone = Tone::srgb;
  /// In place of a tone: the display and the view of the OpenColorIO configuration that $OCIO names. Without
  /// a view nothing; without a display the configuration's first one.
  std::string ocio_display, ocio_view;

  friend bool operator==(const Display&, const Display&) = default;
};

/// Throws Error where $OCIO names no configuration that has the view.
ByteImage displayed(const Image& image, const Display& display);

}  // namespace twinray
