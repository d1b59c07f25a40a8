// SPDX-License-Identifier: Apache-2.0
#include "cli/film/film_keeper.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>

#include "cli/console.h"
#include "cli/film/render_identity.h"
#include "cli/json_names.h"
#include "cli/picture_metadata.h"
#include "core/error.h"
#include "io/destination.h"

namespace twinray {
namespace {

/// Between two checkpoints, where no option says how many.
constexpr std::chrono::duration<double> usual_interval{60};
/// Then they take at most one part in so many of the time.
constexpr int checkpoint_rarity = 100;

/// Of the command line, and of the scene's files.
void check_names(const FilmNotes& notes) {
  check_json_names(notes.words, "a film");
  for (const auto& [name, hash] : notes.identity.files) check_json_names({name}, "a film");
}

/// Whether the checkpoint takes the place of the film to go on with.
bool is_kept_there(const RenderArguments& arguments) {
  return !arguments.checkpoint.empty() &&
         is_same_place(destination_of(arguments.checkpoint), destination_of(arguments.resumed));
}

}  // namespace

bool uses_films(const RenderArguments& arguments) {
  return !arguments.checkpoint.empty() || !arguments.resumed.empty() || is_film_name(arguments.output);
}

FilmKeeper::FilmKeeper(const RenderArguments& arguments, const PictureNotes& picture, const Words& words,
                       const InputFiles& inputs)
    : arguments_(arguments) {
  std::error_code error;
  notes_ = {.identity = render_identity(arguments, inputs),
            .samples = arguments.render.samples,
            .range = arguments.render.range,
            .tiles = arguments.render.tiles,
            .progress = {},
            .is_complete = false,
            .words = words,
            .folder = std::filesystem::current_path(error).string(),
            .picture = picture};
  check_names(notes_);
  if (!arguments.resumed.empty()) {
    auto [film, fault] = open_film_to_resume(arguments.resumed, arguments.render.threads);
    if (!fault.empty()) console::warn(fault);
    if (is_kept_there(arguments)) is_damaged_ = !fault.empty();
    check_can_resume(film, notes_);
    std::set<std::string> engines = engines_of(notes_.picture.metadata);
    engines.merge(engines_of(film.notes.picture.metadata));
    set_engines(notes_.picture.metadata, engines);
    begun_.emplace(std::move(film));
    is_saved_ = !arguments.checkpoint.empty() && has_film(arguments.checkpoint);
  }
  if (arguments.resumed.empty() && !arguments.checkpoint.empty() && has_film(arguments.checkpoint))
    console::warn(fmt::format("{}: the film that is there is replaced; --resume goes on with it",
                              arguments.checkpoint));
  if (!arguments.checkpoint.empty())
    next_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(
                               arguments.checkpoint_seconds.value_or(usual_interval.count())));
}

void FilmKeeper::restore(RenderState& state) {
  if (!begun_) return;
  twinray::restore(*begun_, state, arguments_.render.threads);
  begun_.reset();
}

void FilmKeeper::write(const std::string& path, const RenderState& state, bool is_complete) const {
  FilmNotes notes = notes_;
  notes.is_complete = is_complete;
  write_film(path, notes, state, arguments_.render.threads);
}

/// It would take the place of the good one before it.
void FilmKeeper::drop_damaged() {
  std::error_code error;
  if (is_damaged_) std::filesystem::remove(destination_of(arguments_.checkpoint).path, error);
  is_damaged_ = false;
}

bool FilmKeeper::write_checkpoint(const RenderState& state, bool is_complete) {
  const char* const rest = has_film(arguments_.checkpoint) ? "the one before is as it was" : "there is none";
  try {
    drop_damaged();
    write(arguments_.checkpoint, state, is_complete);
    return is_saved_ = true;
  } catch (const Error& error) {
    console::warn(fmt::format("no checkpoint: {}; {}", error.what(), rest));
  } catch (const std::bad_alloc&) {
    console::warn(
        fmt::format("no checkpoint: {}: there is not enough memory; {}", arguments_.checkpoint, rest));
  }
  return false;
}

bool FilmKeeper::save(const RenderState& state) {
  const Clock::time_point begin = Clock::now();
  const bool is_written = write_checkpoint(state, false);
  const Clock::time_point end = Clock::now();
  const std::chrono::duration<double> interval =
      arguments_.checkpoint_seconds
          ? std::chrono::duration<double>(*arguments_.checkpoint_seconds)
          : std::max<std::chrono::duration<double>>(usual_interval, checkpoint_rarity * (end - begin));
  next_ = end + std::chrono::duration_cast<Clock::duration>(interval);
  return is_written;
}

bool FilmKeeper::save_last(const RenderResult& result) {
  return write_checkpoint(result, result.is_complete);
}

}  // namespace twinray
