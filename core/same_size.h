// SPDX-License-Identifier: Apache-2.0
// Private: what all comparisons of pictures ask first.
#pragma once
#include "core/error.h"

namespace twinray {

/// Throws Error where two pictures, of the same or of different kinds, are not of one size.
template <typename Picture, typename Reference>
void check_same_size(const Picture& picture, const Reference& reference) {
  if (picture.width != reference.width || picture.height != reference.height)
    throw Error("pictures of different sizes cannot be compared");
}

}  // namespace twinray
