// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "core/light.h"

namespace twinray {

/// Throws Error, in the name of the light, where a picture is missing or not of its layout, where axes do not
/// stand at right angles, or where a number is out of the range that core/light.h states.
void check_numbers(const LightSource& source, const std::string& name);

}  // namespace twinray
