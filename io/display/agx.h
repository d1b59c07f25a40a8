// SPDX-License-Identifier: Apache-2.0
// AgX: how film renders a scene whose light has no bound (Troy Sobotka, AgX, 2022). Colours are moved towards
// grey, so that bright saturated light goes to white and not to a corner of the display's colours; each
// channel's logarithm goes through a curve with a toe and a shoulder (Jed Smith's tunable sigmoid); then the
// move is undone.
#pragma once
#include <array>
#include <vector>

#include "core/color_matrix.h"

namespace twinray {

/// The curve, from the logarithm, 0 at ten stops below middle grey (0.18) and 1 at six and a half above, to a
/// display of gamma 2.2, in [0, 1]. Middle grey is 0.5 there.
double agx_curve(double logarithm);

class Agx {
 public:
  Agx();
  /// What a display shows, linear, in [0, 1], of a linear colour by sRGB's primaries.
  Rgb displayed(const Rgb& color) const;

 private:
  double curve(double linear) const;

  ColorMatrix inset_, outset_;
  std::vector<double> table_;  ///< Of agx_curve(), in equal steps.
};

}  // namespace twinray
