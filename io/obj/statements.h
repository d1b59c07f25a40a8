// SPDX-License-Identifier: Apache-2.0
// Private: which statements of an OBJ file are not read.
#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "io/diagnostic.h"

namespace twinray {

/// Looks at the first word of each line (of a text whose continued lines are joined). One that the format
/// does not have is a warning; `place` gives the place of an offset into the text. Returns notes of what the
/// format has, but is left out: how many lines, points, curves and so on.
std::vector<std::string> check_obj_statements(std::string_view text,
                                              const std::function<Place(std::size_t)>& place,
                                              WarningList& warnings);

}  // namespace twinray
