// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>

#include "core/camera.h"

namespace twinray::test {

/// A camera whose lens has two glass surfaces and, at the film's side, a stop: of a focal length of about 1,
/// open to f/4, and a square frame of 0.4 x 0.4. What is at the distance 5 is sharp.
inline Camera camera_with_lens_system() {
  Camera camera;
  camera.lenses = std::make_shared<const LensSystem>(
      focused({{1, 0.05, 1.5, 0.3}, {-1, 0.02, 1, 0.3}, {0, 1, 1, 0.125}}, 5), 0.3);
  camera.tan_half_width = camera.tan_half_height = float(0.2 / camera.lenses->image_distance());
  return camera;
}

}  // namespace twinray::test
