// SPDX-License-Identifier: Apache-2.0
#include "io/generated/generated.h"

#include <array>

namespace twinray::bench {

std::span<const GeneratedScene> generated_scenes() {
  static constexpr std::array<GeneratedScene, 3> all{
      {{"room", 600'000, make_room}, {"ball", 900'000, make_ball}, {"forest", 2'000'000, make_forest}}};
  return all;
}

}  // namespace twinray::bench
