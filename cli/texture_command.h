// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "cli/render_arguments.h"

namespace twinray {

/// Writes each picture of the scene's surfaces with its mip-map into a file beside it, where there is none
/// that is new enough, and renders nothing. The exit code: 1 if one cannot be converted; the others are.
int convert_textures(const RenderArguments& arguments);

/// Each given option that changes nothing in that, with the reason.
std::vector<std::string> options_without_effect_on_conversion(const RenderArguments& arguments);

}  // namespace twinray
