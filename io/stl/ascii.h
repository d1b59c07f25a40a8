// SPDX-License-Identifier: Apache-2.0
// Private: the text form of STL.
#pragma once
#include <string>
#include <string_view>

#include "io/diagnostic.h"
#include "io/obj/reader.h"

namespace twinray {

/// Adds the facets of an ASCII STL file, words in any letters, to the model. As read_stl() has it.
void read_ascii_stl(std::string_view text, const std::string& path, WarningList& warnings, ObjModel& model);

}  // namespace twinray
