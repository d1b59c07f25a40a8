// SPDX-License-Identifier: Apache-2.0
// What a render keeps for whoever goes on with it: checkpoints while it renders, and its film at the end.
#pragma once
#include <atomic>
#include <chrono>
#include <optional>
#include <string>

#include "cli/film/saved_film.h"
#include "cli/render_arguments.h"
#include "io/loaded_scene.h"

namespace twinray {

/// Of the program's process: try again, the work goes on where it was (sysexits.h, EX_TEMPFAIL).
inline constexpr int try_again_code = 75;

/// Whether a render's options ask for a film file, or to go on with one.
bool uses_films(const RenderArguments& arguments);

class FilmKeeper {
 public:
  /// Opens the film that the render is to go on with, and warns where it is the one before. Throws Error
  /// unless it is of the same scene and options, and for names that no film can keep.
  FilmKeeper(const RenderArguments& arguments, const PictureNotes& picture, const Words& words,
             const InputFiles& inputs);

  /// Whether a checkpoint is to be written; from any thread.
  bool is_due() const { return next_.load() <= Clock::now(); }
  /// Fills the state with the film to go on with, if there is one. Throws Error.
  void restore(RenderState& state);
  /// Writes a checkpoint. Where it cannot be written the last one stays, a warning says why, and another is
  /// due later, and the answer is false.
  bool save(const RenderState& state);
  /// Whether checkpoints are asked for.
  bool writes_checkpoints() const { return !arguments_.checkpoint.empty(); }
  /// The last checkpoint; whether it was written.
  bool save_last(const RenderResult& result);
  /// Whether there is a checkpoint to go on with.
  bool has_checkpoint() const { return is_saved_; }
  /// What is said of the picture, with the engines of the film that it goes on with.
  const PictureNotes& picture() const { return notes_.picture; }
  /// Writes what there is of a render to another place. Throws Error.
  void write(const std::string& path, const RenderState& state, bool is_complete) const;

 private:
  using Clock = std::chrono::steady_clock;
  bool write_checkpoint(const RenderState& state, bool is_complete);
  void drop_damaged();

  const RenderArguments& arguments_;
  FilmNotes notes_;
  std::optional<SavedFilm> begun_;  ///< What to go on with.
  bool is_saved_ = false;
  bool is_damaged_ = false;  ///< The file at the checkpoint's place.
  std::atomic<Clock::time_point> next_ = Clock::time_point::max();
};

}  // namespace twinray
