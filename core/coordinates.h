// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace twinray {

/// The coordinates that a scene may have: up to +-10^12.
inline constexpr float max_coordinate = 1e12f;

}  // namespace twinray
