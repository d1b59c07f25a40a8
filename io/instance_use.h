// SPDX-License-Identifier: Apache-2.0
// Whether shapes that a file shows several times become instances (core/instance.h) or copies.
#pragma once
#include <cstddef>

namespace twinray {

enum class InstanceUse {
  automatic,  ///< Instances where copies would take more than most_copied triangles.
  keep,       ///< Instances of whatever the file shows more than once.
  copy        ///< Copies.
};

/// Rays are traced faster through copies: only where there is much to be stored it is stored once.
inline constexpr std::size_t most_copied = 50000;

/// Whether shapes of so many triangles, shown so many times, are stored once.
inline bool are_stored_once(InstanceUse use, std::size_t triangles, std::size_t times) {
  if (use != InstanceUse::automatic) return use == InstanceUse::keep && times > 1;
  return times > 1 && triangles > 0 && times - 1 > most_copied / triangles;
}

}  // namespace twinray
