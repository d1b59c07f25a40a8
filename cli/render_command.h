// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

namespace twinray {

/// twinray [render] SCENE [options]: loads, builds, renders, writes. Throws Error.
void render_command(const std::vector<std::string>& words);

}  // namespace twinray
