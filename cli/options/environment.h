// SPDX-License-Identifier: Apache-2.0
// How the picture of --environment lies around the scene: the same options for all that load one.
#pragma once
#include <string>
#include <vector>

#include "cli/options/options.h"
#include "core/light.h"

namespace twinray {

/// A latitude-longitude picture mirrored, as CS184's program shows it, or as a viewer within sees it, whose
/// right is the picture's, as most programs have it; pbrt-v4's square.
enum class EnvironmentLayout { latitude_longitude, panorama, equal_area };

struct EnvironmentPlacement {
  EnvironmentLayout layout = EnvironmentLayout::latitude_longitude;
  float rotation_degrees = 0;  ///< About +y, counter-clockwise as seen from above.
  float scale = 1;             ///< Times the picture's radiance.
};

/// --environment-layout, --environment-rotation, --environment-scale.
void add_environment_placement(OptionGroup& group, EnvironmentPlacement& placement);
/// Those of them whose words are not the defaults.
std::vector<std::string> changed_options(const EnvironmentPlacement& placement);

/// The light of a picture of radiance. Throws Error, which names the file, where it cannot be of that layout.
EnvironmentLight placed_environment(Image map, const EnvironmentPlacement& placement,
                                    const std::string& file);

}  // namespace twinray
