// SPDX-License-Identifier: Apache-2.0
// What a display shows of linear colours: of pictures in formats of 8 bits. Those of floats keep the light.
#pragma once
#include <optional>
#include <string>

#include "core/image.h"

namespace twinray {

enum class Tone {
  srgb,  ///< As it is, up to 1.
  agx,   ///< As film does (io/display/agx.h).
};

struct Display {
  double exposure_stops = 0;  ///< All light times 2 to this power.
  /// The light of a black body of this temperature becomes white. Kelvin, in white_kelvins.
  std::optional<double> white_kelvin;
  Tone tone = Tone::srgb;
  /// In place of a tone: the display and the view of the OpenColorIO configuration that $OCIO names. Without
  /// a view nothing; without a display the configuration's first one.
  std::string ocio_display, ocio_view;

  friend bool operator==(const Display&, const Display&) = default;
};
inline constexpr double least_white_kelvin = 2000, most_white_kelvin = 25000;

/// Throws Error where $OCIO names no configuration that has the view.
ByteImage displayed(const Image& image, const Display& display);

}  // namespace twinray
