// SPDX-License-Identifier: Apache-2.0
#include "cli/film/film_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "cli/picture_metadata.h"
#include "core/error.h"

namespace twinray {
namespace {

FilmPart part_of(const SavedFilm& film) {
  const FilmNotes& notes = film.notes;
  FilmPart part{film.file.path(), 0, notes.samples, notes.progress, film.file.content(), notes.words};
  if (notes.range) std::tie(part.begin, part.end) = std::pair(notes.range->begin, notes.range->end);
  if (notes.tiles) std::tie(part.begin, part.end) = std::pair(notes.tiles->begin, notes.tiles->end);
  return part;
}

std::string text_of(std::uint32_t begin, std::uint32_t end, const FilmParts& parts) {
  return fmt::format("{} {}:{} of {}", parts.are_tiles() ? "tiles" : "samples", begin, end, parts.whole());
}

std::string text_of(const FilmPart& part, const FilmParts& parts) {
  return text_of(part.begin, part.end, parts);
}

/// Why a film is not of the render that the others are of; empty: it is.
std::string difference(const SavedFilm& film, const FilmParts& parts) {
  const std::string reason = difference(film.notes.identity, parts.notes.identity, "there");
  if (!reason.empty()) return reason;
  if (film.notes.samples != parts.notes.samples)
    return fmt::format("it is of {} samples a pixel, and of {} there", film.notes.samples,
                       parts.notes.samples);
  if (film.file.header().films != parts.contents) return "one has halves of the samples, or other layers";
  if (film.notes.tiles.has_value() != parts.are_tiles())
    return "one is a range of tiles, the other one of samples";
  return "";
}

void add_film(const SavedFilm& film, FilmParts& parts) {
  if (!film.notes.is_complete)
    throw Error(fmt::format("{}: this film is not done; `twinray resume` goes on with it", film.file.path()));
  if (parts.parts.empty()) {
    parts.notes = film.notes;
    parts.contents = film.file.header().films;
  }
  if (const std::string reason = difference(film, parts); !reason.empty())
    throw Error(
        fmt::format("{}: it does not go with {}: {}", film.file.path(), parts.parts.front().path, reason));
  parts.engines.merge(engines_of(film.notes.picture.metadata));
  parts.parts.push_back(part_of(film));
}

bool is_same_range(const FilmPart& a, const FilmPart& b) { return a.begin == b.begin && a.end == b.end; }

/// In order, each range once.
void take_out_repeated(FilmParts& parts) {
  std::stable_sort(parts.parts.begin(), parts.parts.end(), [](const FilmPart& a, const FilmPart& b) {
    return std::pair(a.begin, a.end) < std::pair(b.begin, b.end);
  });
  std::vector<FilmPart> once;
  for (FilmPart& part : parts.parts) {
    if (once.empty() || !is_same_range(once.back(), part)) {
      once.push_back(std::move(part));
      continue;
    }
    if (once.back().content != part.content)
      throw Error(fmt::format("{} and {} are both {}, but their sums are not the same", once.back().path,
                              part.path, text_of(part, parts)));
    parts.repeated.push_back(part.path);
  }
  parts.parts = std::move(once);
}

void find_gaps(FilmParts& parts) {
  std::uint32_t end = 0;
  const FilmPart* before = nullptr;
  for (const FilmPart& part : parts.parts) {
    if (part.begin < end)
      throw Error(fmt::format("{} and {} overlap: {}, and {}", before->path, part.path,
                              text_of(*before, parts), text_of(part, parts)));
    if (part.begin > end) parts.missing.push_back(text_of(end, part.begin, parts));
    end = part.end;
    before = &part;
  }
  if (end < parts.whole()) parts.missing.push_back(text_of(end, parts.whole(), parts));
}

}  // namespace

std::uint32_t FilmParts::whole() const {
  return are_tiles() ? tile_grid(notes.identity.window, tile_size).count() : notes.samples;
}

bool FilmParts::has_inner_gap() const {
  return std::adjacent_find(parts.begin(), parts.end(), [](const FilmPart& a, const FilmPart& b) {
           return a.end != b.begin;
         }) != parts.end();
}

FilmParts read_film_parts(const std::vector<std::string>& paths, Gaps gaps) {
  FilmParts parts;
  for (const std::string& path : paths) add_film(open_film(path), parts);
  take_out_repeated(parts);
  find_gaps(parts);
  if (!parts.missing.empty() && gaps == Gaps::refused)
    throw Error(
        fmt::format("{} {} missing{}; --allow-gaps merges what there is", parts.missing.front(),
                    parts.missing.size() == 1 ? "are" : "and others are",
                    parts.missing.size() == 1 ? "" : fmt::format(" ({} gaps)", parts.missing.size())));
  return parts;
}

RenderState merged(const FilmParts& parts, int threads) {
  const RenderIdentity& identity = parts.notes.identity;
  const auto make = [&](std::size_t i) {
    return Film(identity.width, identity.height, identity.window, parts.contents[i]);
  };
  RenderState state{make(0)};
  if (parts.contents.size() > 1) state.halves = HalfFilms{make(1), make(2)};
  const std::vector<Film*> films = films_of(state);
  for (const FilmPart& part : parts.parts) {
    FilmFile(part.path).merge_into(films, threads);
    state.rays += part.progress.rays;
    state.seconds += part.progress.seconds;
    state.samples = std::max(state.samples, part.progress.samples);
  }
  return state;
}

}  // namespace twinray
