// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>

#include "core/light.h"
#include "core/transform.h"

namespace twinray {

class GltfDocument;

/// A light of KHR_lights_punctual where a node puts it: candela are our intensity, lux our irradiance, number
/// by number. `light` is an index into the extension's lights. None, with a warning, where the transform
/// gives it no direction that it needs. Throws Error where there is no such light.
std::optional<Light> read_gltf_light(GltfDocument& document, int light, int node, const Transform& to_world);

}  // namespace twinray
