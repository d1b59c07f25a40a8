// SPDX-License-Identifier: Apache-2.0
#include "cli/cs184/screenshot_name.h"

#include <fmt/format.h>

namespace twinray {

std::string screenshot_name(const std::string& scene, const std::tm& time) {
  const std::string file = scene.substr(scene.find_last_of('/') + 1);
  return fmt::format("{}_screenshot_{}-{}_{}-{}-{}.png", file.substr(0, file.find(".dae")), time.tm_mon + 1,
                     time.tm_mday, time.tm_hour, time.tm_min, time.tm_sec);
}

}  // namespace twinray
