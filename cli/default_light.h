// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/camera.h"
#include "core/scene.h"

namespace twinray {

/// Whether any light of the scene sends light.
bool is_lit(const Scene& scene);

/// A light at the camera, or along an orthographic one, that does not fall off: a white surface that faces
/// the camera has radiance 1, whatever the scene's unit is.
Light headlight(const Camera& camera);

}  // namespace twinray
