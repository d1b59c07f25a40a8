// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "core/camera.h"
#include "core/scene.h"

namespace twinray {

/// Whether any light of the scene sends light.
bool is_lit(const Scene& scene);

/// For scenes that have none: a soft sky above all, and a weaker light at the camera, or along an
/// orthographic one, that does not fall off. A white surface that stands upright and faces the camera has
/// radiance 1, whatever the scene's unit is.
std::vector<Light> default_lights(const Camera& camera);

}  // namespace twinray
