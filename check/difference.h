// SPDX-License-Identifier: Apache-2.0
// Two renders of one picture, compared bit for bit.
#pragma once
#include <optional>
#include <string>

#include "integrators/render.h"

namespace twinray {

/// The first difference between two films, row by row from the top left: the sums and sample counts of each
/// pixel of `found`, whose window lies within that of `expected` (the same frame and layers; else that is the
/// difference), and what is kept besides. In words, sums as hexadecimal floats: "pixel 3 4: red 0x1.8p+0 and
/// 0x1.9p+0". None if all bits are the same.
std::optional<std::string> first_difference(const Film& expected, const Film& found);

/// The same for rays by kind: "shadow rays 12 and 13".
std::optional<std::string> first_difference(const RayCounts& expected, const RayCounts& found);

}  // namespace twinray
