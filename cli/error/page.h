// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "cli/error/tables.h"

namespace twinray::error {

/// The page of a summary: tables, error over samples and over CPU seconds, and where each set's pictures are
/// brighter or darker than the reference. One file with no script and nothing to load.
std::string error_page(const Heading& heading, const Summary& summary, const std::string& command);

}  // namespace twinray::error
