// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "check/crosscheck.h"

namespace twinray {

/// The most differences that a tally may have, though each of them is explained. embree-native in its robust
/// mode stays below on meshes such as scanned models; canonical engines have no differences at all.
struct Ceiling {
  enum class Counts { odd, leaks };
  Counts counts = Counts::odd;
  std::uint64_t most = 0;
};

/// Camera, bounce and random rays: 10^-4 of them neither identical nor rounding. Edges: no leak. Vertices:
/// leaks of 0.5 %. No ceiling for the other classes. Fractions are rounded up to whole rays.
std::optional<Ceiling> ceiling_of(RayClass ray_class, std::uint64_t rays);

/// A cell of the report whose ceiling is passed.
struct PassedCeiling {
  std::size_t engine = 0;
  RayClass ray_class = RayClass::camera;
  Ceiling ceiling;
  std::uint64_t found = 0;
};

/// All of them, by engine and ray class.
std::vector<PassedCeiling> passed_ceilings(const CrosscheckReport& report);

}  // namespace twinray
