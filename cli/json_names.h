// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

namespace twinray {

/// Throws Error with the first of the names that is not UTF-8: JSON has no other text, and under another name
/// there is another file. `holder` is what is to keep them: "a film".
void check_json_names(const std::vector<std::string>& names, const char* holder);

}  // namespace twinray
