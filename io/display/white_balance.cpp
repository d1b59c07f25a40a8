// SPDX-License-Identifier: Apache-2.0
#include "io/display/white_balance.h"

#include <array>

namespace twinray {

ColorMatrix white_balance(const Rgb& light) {
  const ColorMatrix to_cones = product(bradford, to_xyz(srgb_primaries));
  using Triple = std::array<double, 3>;
  const Triple from = transformed(to_cones, Triple{light.r, light.g, light.b}),
               to = transformed(to_cones, Triple{1, 1, 1});
  return product(inverse(to_cones), adapted(to_cones, from, to));
}

}  // namespace twinray
