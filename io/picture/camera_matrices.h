// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/camera.h"
#include "io/picture/image_metadata.h"

namespace twinray {

/// The matrices of the camera that a picture's whole frame was seen by (fit_frame).
CameraMatrices camera_matrices(const Camera& camera);

}  // namespace twinray
