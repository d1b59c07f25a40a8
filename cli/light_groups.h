// SPDX-License-Identifier: Apache-2.0
// --light-group: which lights stand together in a picture's layers.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "core/scene.h"

namespace twinray {

/// One group of the command line.
struct LightGroupRule {
  std::string name;                 ///< As layers have it.
  std::vector<std::string> lights;  ///< Their names, where * stands for any text.
};

/// "key=Lamp*,Sun". Throws UsageError.
LightGroupRule parse_light_group(const std::string& text);

/// More layers of lights than a picture can be asked for.
inline constexpr std::size_t most_light_groups = 64;

/// Gives each light its group: the first rule that names it, else one of its own name, or of the lights of
/// that name. Throws Error for a rule that names no light, and for more than most_light_groups.
void group_lights(Scene& scene, std::span<const LightGroupRule> rules);

/// A name as layers can have it: other characters than letters, digits and "-" are "_".
std::string layer_word(const std::string& name);

}  // namespace twinray
