// SPDX-License-Identifier: Apache-2.0
#include "cli/film/saved_film.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "core/error.h"

namespace twinray {
namespace {

/// Why samples of a picture with so many a pixel are not those of one with as many as here; empty: they are.
std::string sample_difference(const FilmNotes& film, const FilmNotes& here) {
  if (film.samples == here.samples) return "";
  if (film.range || here.range || film.tiles || here.tiles)
    return fmt::format("it is a part of a picture of {} samples, and of {} here", film.samples, here.samples);
  if (film.samples == 1 || here.samples == 1)
    return fmt::format(
        "it is of {} samples a pixel, and of {} here: the one sample of a pixel lies in its middle",
        film.samples, here.samples);
  return "";
}

std::string part_difference(const FilmNotes& film, const FilmNotes& here) {
  if (film.range == here.range && film.tiles == here.tiles) return "";
  return fmt::format("it has {}, and {} are wanted here", part_text(film), part_text(here));
}

/// Of that name or, where `open` throws Error for it, of the one that it replaced; `fault` then says why.
template <typename Open>
auto open_or_earlier(const std::string& path, std::string& fault, const Open& open) {
  try {
    return open(path);
  } catch (const Error& error) {
    const std::string earlier = earlier_film_name(path);
    if (!std::filesystem::exists(earlier)) throw;
    fault = fmt::format("{}; {} is taken in its place", error.what(), earlier);
    try {
      return open(earlier);
    } catch (const Error& earlier_error) {
      throw Error(fmt::format("{}; {}", error.what(), earlier_error.what()));
    }
  }
}

/// Whether it is there, and no empty file.
bool holds_something(const std::string& path) {
  std::error_code error;
  return std::filesystem::exists(path, error) && !std::filesystem::is_empty(path, error);
}

}  // namespace

bool is_film_name(const std::string& path) { return std::filesystem::path(path).extension() == ".film"; }

bool has_film(const std::string& path) {
  return holds_something(path) || holds_something(earlier_film_name(path));
}

void check_films_alone_are_replaced(const std::string& checkpoint) {
  for (const std::string& name : {checkpoint, earlier_film_name(checkpoint)})
    if (holds_something(name) && std::filesystem::is_regular_file(name) && !begins_as_film(name))
      throw Error(fmt::format(
          "--checkpoint={}: {} is no film file of this version of the program, and is not replaced; choose "
          "another name",
          checkpoint, name));
}

std::uint64_t write_film(const std::string& path, const FilmNotes& notes, const RenderState& state,
                         int threads) {
  FilmNotes all = notes;
  all.progress = {state.rays, state.samples, state.next_estimate, state.error, state.seconds};
  std::vector<const Film*> films{&state.film};
  if (state.halves) films.insert(films.end(), {&state.halves->first, &state.halves->second});
  return write_film_file(path, films, film_notes_json(all), threads);
}

SavedFilm open_film(const std::string& path) {
  FilmFile file(path);
  try {
    FilmNotes notes = parse_film_notes(file.header().notes);
    return {std::move(file), std::move(notes)};
  } catch (const Error& error) {
    throw Error(fmt::format("{}: {}", path, error.what()));
  }
}

std::vector<Film*> films_of(RenderState& state) {
  if (!state.halves) return {&state.film};
  return {&state.film, &state.halves->first, &state.halves->second};
}

FilmNotes notes_to_resume(const std::string& path) {
  std::string fault;
  return open_or_earlier(path, fault, [](const std::string& name) { return open_film(name).notes; });
}

FilmToResume open_film_to_resume(const std::string& path, int threads) {
  std::string fault;
  SavedFilm film = open_or_earlier(path, fault, [&](const std::string& name) {
    SavedFilm opened = open_film(name);
    opened.file.check(threads);
    return opened;
  });
  return {std::move(film), std::move(fault)};
}

void check_can_resume(const SavedFilm& film, const FilmNotes& here) {
  std::string reason = difference(film.notes.identity, here.identity, "here");
  if (reason.empty()) reason = part_difference(film.notes, here);
  if (reason.empty()) reason = sample_difference(film.notes, here);
  if (!reason.empty())
    throw Error(fmt::format("{}: this film cannot go on here: {}", film.file.path(), reason));
}

void restore(SavedFilm& film, RenderState& state, int threads) {
  const std::vector<Film*> films = films_of(state);
  const std::vector<FilmContents>& saved = film.file.header().films;
  if (saved.size() < films.size())
    throw Error(fmt::format("{}: it has no halves of the samples, which --denoise and --noise-target need",
                            film.file.path()));
  if (saved.size() > films.size())
    throw Error(fmt::format("{}: it has halves of the samples, as a render with --denoise or --noise-target",
                            film.file.path()));
  if (films.size() > 1 && films[1]->contents() != saved[1])
    throw Error(fmt::format(
        "{}: its halves have other layers; --denoise and --denoise-light-groups go with a render's beginning",
        film.file.path()));
  film.file.merge_into(films, threads);
  const FilmProgress& progress = film.notes.progress;
  state.rays = progress.rays;
  state.samples = progress.samples;
  state.next_estimate = progress.next_estimate;
  state.error = progress.error;
  state.seconds = progress.seconds;
}

}  // namespace twinray
