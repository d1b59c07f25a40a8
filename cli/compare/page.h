// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "cli/compare/comparison.h"

namespace twinray::compare {

/// The page of a comparison: both pictures under a slider, maps of their differences, and the table. One file
/// with nothing to load.
std::string compare_page(const Comparison& comparison, const std::string& command);

}  // namespace twinray::compare
