// SPDX-License-Identifier: Apache-2.0
#include "cli/render_keeping.h"

#include <fmt/format.h>

#include <new>

#include "cli/console.h"
#include "cli/partial_picture.h"
#include "cli/shell_text.h"
#include "core/error.h"

namespace twinray {

RenderOptions RenderKeeping::resting(RenderOptions options) {
  options.is_pause_due = [this] { return request_.is_made() || (keeper_ && keeper_->is_due()); };
  options.paused = [this](const RenderState& state) { rest(state); };
  if (keeper_) options.restore = [this](RenderState& state) { keeper_->restore(state); };
  if (keeper_ && keeper_->writes_checkpoints())
    options.failed = [this](const RenderState& state) {
      if (keeper_->save(state)) talk_.checkpointed();
    };
  return options;
}

void RenderKeeping::rest(const RenderState& state) {
  const bool is_asked = request_.take();
  // A film beside a checkpoint would be the same once more.
  const bool asks_for_checkpoint = is_asked && !partial_.film.empty() && !arguments_.checkpoint.empty();
  if (keeper_ && (keeper_->is_due() || asks_for_checkpoint) && keeper_->save(state)) talk_.checkpointed();
  if (!is_asked || asks_for_checkpoint || partial_.names().empty()) return;
  try {
    talk_.note(write_so_far(state));
  } catch (const Error& error) {
    console::warn(fmt::format("{}; the render goes on", error.what()));
  } catch (const std::bad_alloc&) {
    console::warn("there is not enough memory for a picture of what there is; the render goes on");
  }
}

std::string RenderKeeping::write_so_far(const RenderState& state) {
  if (partial_.film.empty()) return write_partial(partial_, arguments_, state.film, notes_);
  keeper_->write(partial_.film, state, false);
  return partial_.film + " holds what there is";
}

bool RenderKeeping::save_last(const RenderResult& result) {
  if (!keeper_ || !keeper_->writes_checkpoints()) return true;
  const bool is_saved = keeper_->save_last(result);
  if (is_saved) talk_.checkpointed();
  return is_saved;
}

int RenderKeeping::interrupted(const RenderResult& result, const StopRequest& stop, const char* when) {
  const bool is_kept = keeper_ && keeper_->has_checkpoint();
  // A film beside a checkpoint would be the same once more.
  const bool is_told = !partial_.names().empty() && !(is_kept && !partial_.film.empty());
  std::string so_far;
  try {
    if (is_told) so_far = "; " + write_so_far(result);
  } catch (const Error& error) {
    if (!is_kept) throw;
    console::warn(error.what());
  }
  console::print_error("{}: {}{}{}\n", console::speaker(), stop.text(), when, so_far);
  if (!is_kept) return stop.exit_code();
  console::print_error("{}: `twinray resume {}` goes on with it\n", console::speaker(),
                       shell_text({arguments_.checkpoint}));
  return try_again_code;
}

}  // namespace twinray
