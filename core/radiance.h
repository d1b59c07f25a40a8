// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace twinray {

/// The greatest radiance that readers, environment maps and the film take. The sun's, 2 * 10^7 W / (m^2 sr),
/// is a fiftieth of it.
inline constexpr float max_radiance = 1e9f;

}  // namespace twinray
