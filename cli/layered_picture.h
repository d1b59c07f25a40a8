// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/film.h"
#include "io/layered_image.h"

namespace twinray {

/// The picture of a film that has layers: R, G, B, then the channels of its layers. The film must outlive it.
LayeredImage layered_picture(const Film& film);

}  // namespace twinray
