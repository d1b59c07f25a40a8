// SPDX-License-Identifier: Apache-2.0
// Lights mixed anew after a picture was rendered: light adds up, so the picture is the sum of what its light
// groups bring, each times a colour.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "core/image.h"
#include "io/picture/layered_image.h"

namespace twinray {

/// What becomes of a light group.
struct LightChange {
  std::string group;
  Rgb factor{1, 1, 1};  ///< Times its light; >= 0.
};

/// The names of the light groups that a picture holds.
std::vector<std::string> light_groups_of(const StoredLayers& picture);

/// Changes the groups' layers, and makes the colours their sum. What said how bright or how noisy the light
/// was as a whole is taken out: its parts by path, its variance, the noisy picture of a denoised one. Throws
/// Error, which names the file, for a group that there is not, and for a picture without R, G, B and groups.
void relight(StoredLayers& picture, std::span<const LightChange> changes, const std::string& path);

/// R, G and B.
Image colors_of(const StoredLayers& picture);

}  // namespace twinray
