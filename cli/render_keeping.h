// SPDX-License-Identifier: Apache-2.0
// What is kept of a render before it is done: checkpoints, and pictures of what there is so far.
#pragma once
#include <optional>
#include <string>

#include "cli/film/film_keeper.h"
#include "cli/interrupt.h"
#include "cli/render_outputs.h"
#include "cli/render_talk.h"

namespace twinray {

/// All that it is made of must outlive it.
class RenderKeeping {
 public:
  /// `partial`: what is written of a render that is not done; no names: nothing.
  RenderKeeping(const RenderArguments& arguments, const RenderOutputs& partial, const PictureNotes& notes,
                RenderTalk& talk, PictureRequest& request)
      : arguments_(arguments), partial_(partial), notes_(notes), talk_(talk), request_(request) {}

  /// To be called where uses_films(): opens the film to go on with, if there is one. Throws Error where it
  /// is of another render.
  void use_films(const Words& words, const InputFiles& inputs) {
    keeper_.emplace(arguments_, notes_, words, inputs);
  }
  FilmKeeper* films() { return keeper_ ? &*keeper_ : nullptr; }
  /// Whether anything stays of a render that is interrupted.
  bool keeps_something() const { return !partial_.names().empty() || !arguments_.checkpoint.empty(); }

  /// The options of a render that comes here to rest.
  RenderOptions resting(RenderOptions options);
  /// Writes the last checkpoint of a render, if one is asked for; false where it cannot be written, which a
  /// warning says.
  bool save_last(const RenderResult& result);
  /// Once the last checkpoint is written: keeps what there is, and says where. `when` it was interrupted ("
  /// while it was denoised") may be empty. The exit code: that of an interrupted program or, where it can go
  /// on, try_again_code.
  int interrupted(const RenderResult& result, const StopRequest& stop, const char* when);

 private:
  void rest(const RenderState& state);
  /// A sentence of what is written.
  std::string write_so_far(const RenderState& state);

  const RenderArguments& arguments_;
  const RenderOutputs& partial_;
  const PictureNotes& notes_;
  RenderTalk& talk_;
  PictureRequest& request_;
  std::optional<FilmKeeper> keeper_;
};

}  // namespace twinray
