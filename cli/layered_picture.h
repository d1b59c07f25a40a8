// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/film.h"
#include "core/image.h"
#include "io/layered_image.h"

namespace twinray {

/// The picture of a film that has layers: R, G, B, then the channels of its layers. Where there is a denoised
/// picture of it, R, G, B are those, and noisy.R, noisy.G, noisy.B the film's own, the last of all. Both must
/// outlive it.
LayeredImage layered_picture(const Film& film, const Image* denoised = nullptr);

}  // namespace twinray
