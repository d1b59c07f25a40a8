// SPDX-License-Identifier: Apache-2.0
// What all writers of scene files take and give: io/scene_writer.h chooses one.
#pragma once
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/scene.h"
#include "io/losses.h"
#include "io/render_defaults.h"

namespace twinray {

/// What is written. It must outlive what is made of it.
struct SceneToWrite {
  const Scene& scene;
  RenderDefaults picture;  ///< Its resolution is always there: the camera's frame is widened to it.
};

/// A file, and what writes it as a whole (io/output_file.h) or throws Error.
struct SceneFile {
  std::string path;
  std::function<void(const std::string& path)> write;
};

/// All files of a scene, the one that was asked for last: where it is, all is there.
struct WrittenScene {
  std::vector<SceneFile> files;
  std::vector<std::string> warnings;  ///< What the format cannot say, a line for each kind.
  std::shared_ptr<const Scene> scene =
      nullptr;  ///< What the files are made of, where it is not what was given.
};

/// A scene that is being written: its files so far, and what was lost.
class SceneOutput {
 public:
  explicit SceneOutput(std::string path) : path_(std::move(path)) {}

  const std::string& path() const { return path_; }
  /// Adds a file beside the one that was asked for: of "room.pbrt" and "-3.ply" it is "room-3.ply". Returns
  /// its name without the folder.
  std::string add(const std::string& suffix, std::function<void(const std::string& path)> write);
  /// With the file that was asked for, which is text or other bytes.
  WrittenScene finish(std::string bytes);

  Losses losses;

 private:
  std::string path_;
  std::vector<SceneFile> files_;
};

/// Names that are used once: of a second "a" it is "a 2". One that is empty is `otherwise`.
class UniqueNames {
 public:
  std::string unique(const std::string& name, const std::string& otherwise);

 private:
  std::map<std::string, int> used_;  ///< How often each was wanted.
};

/// Whether what a shape looks like differs by its texture coordinates.
bool is_textured(const Scene& scene, const ShapeBinding& binding);

/// The name of a file without its folder.
std::string name_of_file(const std::string& path);

}  // namespace twinray
