// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace twinray {

/// How many mixes (core/material.h) may be in each other: what asks for all parts of one may have to ask for
/// twice as many with each.
inline constexpr int most_nested_mixes = 10;

}  // namespace twinray
