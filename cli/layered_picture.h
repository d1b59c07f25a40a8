// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "cli/denoising.h"
#include "cli/scene_names.h"
#include "core/film.h"
#include "io/picture/image_metadata.h"
#include "io/picture/layered_image.h"

namespace twinray {

/// The picture of a film: R, G, B, then the channels of its layers, then the parts of its light. Where there
/// is a denoised picture of it, R, G, B are those, and noisy.R, noisy.G, noisy.B the film's own, and so are
/// light groups that are denoised: noisy_light_NAME.R; these are the last of all. Film and picture must
/// outlive it.
LayeredImage layered_picture(const Film& film, const SceneNames& names,
                             const DenoisedPicture* denoised = nullptr);

/// What the file says of the numbers in these layers: the mattes' manifests, the names of ids.
ImageMetadata layer_metadata(const FilmContents& contents, const SceneNames& names);

/// The name of a light group's layer: its channels are this, a dot, and R, G or B.
inline std::string light_group_layer(const std::string& group) { return "light_" + group; }

}  // namespace twinray
