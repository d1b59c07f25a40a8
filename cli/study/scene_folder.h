// SPDX-License-Identifier: Apache-2.0
// The scenes that a study finds.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace twinray::study {

struct FoundScene {
  std::string name;  ///< Of its file without the ending; with its folders in front where two have the same.
  std::string path;
  std::size_t primitives = 0;          ///< Triangles and spheres.
  bool has_only_point_lights = false;  ///< One at least: hemisphere sampling finds no light.
};

struct UnreadableScene {
  std::string path, reason;
};

/// All COLLADA files (.dae) of a folder and the folders below it, in the order of their paths.
struct SceneFolder {
  std::string path;
  std::vector<FoundScene> scenes;
  std::vector<UnreadableScene> unreadable;

  /// The first scene of that name, whatever its case; null where there is none.
  const FoundScene* find(const std::string& name) const;
};

/// Reads every scene once. Throws Error where there is no such folder, or no scene in it that can be read.
SceneFolder read_scene_folder(const std::string& path);

}  // namespace twinray::study
