// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

namespace twinray {

/// Which of a mesh's two sets of texture coordinates a picture goes by. A mesh of one set has the first for
/// both.
enum class CoordinateSet : std::uint8_t { first, second };

}  // namespace twinray
