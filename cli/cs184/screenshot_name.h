// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <ctime>
#include <string>

namespace twinray {

/// The name that CS184's program gives to a picture for which there is no other: "dae/sky/CBbunny.dae" ->
/// "CBbunny_screenshot_4-9_16-5-0.png", with month and day, hour, minute and second, as short as they are.
std::string screenshot_name(const std::string& scene, const std::tm& time);

}  // namespace twinray
