// SPDX-License-Identifier: Apache-2.0
// The scene of a picture that shows motion (docs/motion.md).
#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/render_arguments.h"
#include "integrators/motion.h"
#include "io/loaded_scene.h"

namespace twinray {

/// When a file was written last, and how long it is: nothing of one that is not there.
struct FileState {
  std::string path;
  std::optional<std::filesystem::file_time_type> written;
  std::uintmax_t bytes = 0;
  bool operator==(const FileState&) const = default;
};

/// The scene at one moment after the other: only the last one is in memory.
class MovingScene {
 public:
  /// `first` is what load_for_render has made of the arguments just now, which have a shutter. It must
  /// outlive this.
  MovingScene(const RenderArguments& arguments, const LoadedScene& first);

  /// The options of a render of it, which it must outlive.
  Motion motion();
  /// At a part of the time that the shutter is open. The answer holds until the next one. Throws Error, with
  /// the time, also where a file of the scene has changed.
  TracedScene at(double part);
  /// The time of a render's sample, in seconds.
  double time_of(std::uint32_t sample) const;
  /// As a render has it for a sample.
  TracedScene of_sample(std::uint32_t sample);

 private:
  RenderArguments arguments_;
  const LoadedScene& first_;
  std::vector<FileState> files_;  ///< Of the scene, when it was read first.
  std::optional<LoadedScene> loaded_;
  std::unique_ptr<const Accelerator> accelerator_;
  std::unique_ptr<const Integrator> integrator_;
};

}  // namespace twinray
