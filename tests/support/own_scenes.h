// SPDX-License-Identifier: Apache-2.0
// Scenes of scenes/ that many tests render, each a word of the shell.
#pragma once
#include <string>

namespace twinray::test {

inline const std::string box_scene = TWINRAY_SOURCE_DIR "/scenes/box.dae",
                         spheres_scene = TWINRAY_SOURCE_DIR "/scenes/spheres.dae";

}  // namespace twinray::test
