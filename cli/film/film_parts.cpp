// SPDX-License-Identifier: Apache-2.0
#include "cli/film/film_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/error.h"

namespace twinray {
namespace {

FilmPart read_part(const std::string& path) {
  SavedFilm film = open_film(path);
  return {path, std::move(film.notes), film.file.header().films, film.file.content()};
}

struct Place {
  std::uint32_t begin = 0, end = 0;
  auto operator<=>(const Place&) const = default;
};

Place place_of(const FilmPart& part) {
  if (part.notes.tiles) return {part.notes.tiles->begin, part.notes.tiles->end};
  if (part.notes.range) return {part.notes.range->begin, part.notes.range->end};
  return {0, part.notes.samples};
}

/// Of all films together.
Place whole_of(const FilmParts& parts) {
  const FilmNotes& notes = parts.parts.front().notes;
  return {0, parts.is_by_tiles ? tile_grid(notes.identity.window, tile_size).count() : notes.samples};
}

std::string text_of(const Place& place, const FilmParts& parts) {
  return fmt::format("{} {} to {} of {}", parts.is_by_tiles ? "tiles" : "samples", place.begin, place.end,
                     whole_of(parts).end);
}

/// Throws Error unless both are of one render.
void check_same(const FilmPart& first, const FilmPart& part) {
  const auto fail = [&](const std::string& reason) {
    throw Error(fmt::format("{}: it does not go with {}: {}", part.path, first.path, reason));
  };
  // As seen from the first one: "here" is the film that is looked at.
  if (const std::string reason = difference(first.notes.identity, part.notes.identity); !reason.empty())
    fail(reason);
  if (first.notes.samples != part.notes.samples)
    fail(fmt::format("{} samples a pixel, and {} here", first.notes.samples, part.notes.samples));
  if (first.contents != part.contents) fail("one has halves of the samples, or other layers");
  if (first.notes.tiles.has_value() != part.notes.tiles.has_value())
    fail("one is a range of tiles, the other one of samples");
}

void check_done(const FilmPart& part) {
  if (!part.notes.is_complete)
    throw Error(fmt::format("{}: this film is not done; `twinray resume` goes on with it", part.path));
}

/// In order, each place once.
void take_out_repeated(FilmParts& parts) {
  std::vector<FilmPart>& all = parts.parts;
  std::stable_sort(all.begin(), all.end(),
                   [](const FilmPart& a, const FilmPart& b) { return place_of(a) < place_of(b); });
  std::vector<FilmPart> once;
  for (FilmPart& part : all) {
    if (once.empty() || place_of(once.back()) != place_of(part)) {
      once.push_back(std::move(part));
      continue;
    }
    if (once.back().content != part.content)
      throw Error(fmt::format("{} and {} are both {}, but their sums are not the same", once.back().path,
                              part.path, part_text(part.notes)));
    parts.repeated.push_back(part.path);
  }
  all = std::move(once);
}

void find_gaps(FilmParts& parts) {
  const Place whole = whole_of(parts);
  std::uint32_t end = whole.begin;
  const FilmPart* before = nullptr;
  for (const FilmPart& part : parts.parts) {
    const Place place = place_of(part);
    if (place.begin < end)
      throw Error(fmt::format("{} and {} overlap: {}, and {}", before->path, part.path,
                              part_text(before->notes), part_text(part.notes)));
    if (place.begin > end) parts.missing.push_back(text_of({end, place.begin}, parts));
    end = place.end;
    before = &part;
  }
  if (end < whole.end) parts.missing.push_back(text_of({end, whole.end}, parts));
  parts.begin = place_of(parts.parts.front()).begin;
  parts.end = end;
}

}  // namespace

bool is_next(const FilmPart& a, const FilmPart& b) { return place_of(a).end == place_of(b).begin; }

FilmParts read_film_parts(const std::vector<std::string>& paths, Gaps gaps) {
  FilmParts parts;
  for (const std::string& path : paths) {
    parts.parts.push_back(read_part(path));
    check_same(parts.parts.front(), parts.parts.back());
    check_done(parts.parts.back());
  }
  parts.is_by_tiles = parts.parts.front().notes.tiles.has_value();
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
  const FilmPart& first = parts.parts.front();
  const RenderIdentity& identity = first.notes.identity;
  const auto make = [&](std::size_t i) {
    return Film(identity.width, identity.height, identity.window, first.contents[i]);
  };
  RenderState state{make(0)};
  std::vector<Film*> films{&state.film};
  if (first.contents.size() > 1) {
    state.halves = HalfFilms{make(1), make(2)};
    films.insert(films.end(), {&state.halves->first, &state.halves->second});
  }
  for (const FilmPart& part : parts.parts) {
    FilmFile(part.path).merge_into(films, threads);
    state.rays += part.notes.progress.rays;
    state.seconds += part.notes.progress.seconds;
    state.samples = std::max(state.samples, part.notes.progress.samples);
  }
  return state;
}

}  // namespace twinray
