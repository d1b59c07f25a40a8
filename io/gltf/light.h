// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/light.h"
#include "core/transform.h"

namespace twinray {

class GltfDocument;

/// A light of KHR_lights_punctual where a node puts it: candela are our intensity, lux our irradiance, number
/// by number. `light` is an index into the extension's lights. Throws Error where there is no such light.
Light read_gltf_light(GltfDocument& document, int light, int node, const Transform& to_world);

}  // namespace twinray
