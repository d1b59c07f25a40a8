// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/texture_model.h"

namespace twinray {

/// How long a map makes vectors, on the average over the axes.
float mean_stretch(const PointTransform& map);

/// Where the pattern of a placed texture is asked for: with its own point, coordinates and footprint.
TexturePoint placed_point(const PlacedTexture& texture, const TexturePoint& at);

}  // namespace twinray
