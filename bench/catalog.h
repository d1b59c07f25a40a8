// SPDX-License-Identifier: Apache-2.0
// Which scenes there are, and which of them are measured.
#pragma once
#include <string>
#include <vector>

#include "bench/workload.h"

namespace twinray::bench {

/// What is asked for on the command line, as far as it concerns scenes.
struct SceneChoice {
  std::string own_scenes;          ///< The folder of the scenes that are part of this project.
  std::string folder;              ///< A folder with scene files, searched with all below it; may be empty.
  std::vector<std::string> files;  ///< Scene files besides.
  std::vector<std::string> only;   ///< Regular expressions; where there are some, a name must match one.
  std::vector<std::size_t> sizes;  ///< Triangles of the generated scenes that show growth.
  std::size_t size_divisor = 1;    ///< Generated scenes have their usual size divided by this.
  bool is_full = false;            ///< Every file of the folder, and growth of every generated scene.
};

/// Two scenes of our own; the well-known ones that the folder holds (cow, CBbunny, CBlucy, CBdragon, CBgems,
/// CBspheres_lambertian); room, ball and forest; and the forest in each of the sizes, as "forest-10000".
/// Small ones come first within each kind. Throws Error for a folder that is none, and UsageError for a
/// bad regular expression, a size that the forest cannot have, or where nothing is left.
std::vector<SceneSource> choose_scenes(const SceneChoice& choice);

}  // namespace twinray::bench
