// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "io/written_scene.h"

namespace twinray {

/// The statements of the lights that are no shapes.
std::string pbrt_lights(const Scene& scene, SceneOutput& output);

/// What stands before a shape that is this light, which is a mesh or a sphere.
std::string pbrt_area_light(const Scene& scene, std::uint32_t light, SceneOutput& output);

}  // namespace twinray
