// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/color_matrix.h"
#include "core/image.h"

namespace twinray {

/// Brings colours by these primaries to ours, unless they are ours. What has no negative number has none
/// then, either: where ours cannot say a colour, what is too little of a channel is 0. Greys are the same by
/// all primaries. Colours stay as they are where the primaries are none, as if nothing were said of them.
void take_as_srgb(const Primaries& primaries, Image& image);

}  // namespace twinray
