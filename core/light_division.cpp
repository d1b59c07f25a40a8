// SPDX-License-Identifier: Apache-2.0
#include "core/light_division.h"

namespace twinray {

const char* light_path_name(LightPath path) {
  static constexpr std::array<const char*, light_path_count> names{
      "emission",      "environment",     "diffuse_direct",      "diffuse_indirect",
      "glossy_direct", "glossy_indirect", "transmission_direct", "transmission_indirect"};
  return names[std::size_t(path)];
}

}  // namespace twinray
