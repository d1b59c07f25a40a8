// SPDX-License-Identifier: Apache-2.0
#include "integrators/layer_records.h"

namespace twinray {

bool has_environment(const Scene& scene) {
  const auto is_environment = [](const Light& light) {
    return std::holds_alternative<EnvironmentLight>(light.source);
  };
  return std::any_of(scene.lights.begin(), scene.lights.end(), is_environment);
}

}  // namespace twinray
