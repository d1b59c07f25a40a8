// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "io/written_scene.h"

namespace twinray {

/// The statements before WorldBegin: camera, film, sampler, integrator and pixel filter.
std::string pbrt_view(const SceneToWrite& input, SceneOutput& output);

}  // namespace twinray
