// SPDX-License-Identifier: Apache-2.0
// The state of a render as a film file.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "cli/film/film_notes.h"
#include "io/film/film_file.h"

namespace twinray {

/// Whether a name is that of a film file: it ends in ".film".
bool is_film_name(const std::string& path);

/// Whether there is a film to go on with, by that name or as the one before.
bool has_film(const std::string& path);

/// Throws Error where a file that is no film is at the place of a checkpoint of this name, or of the one
/// before. A damaged film is one, and an empty file is no loss.
void check_films_alone_are_replaced(const std::string& checkpoint);

/// Writes what there is of a render; the notes but for its progress. Returns the bytes. Throws Error.
std::uint64_t write_film(const std::string& path, const FilmNotes& notes, const RenderState& state,
                         int threads);

/// The films of a state, as they stand in a file: that of all samples, and the halves, if there are any.
std::vector<Film*> films_of(RenderState& state);

struct SavedFilm {
  FilmFile file;
  FilmNotes notes;
};
/// Throws Error where it is none, or its beginning or its end is damaged.
SavedFilm open_film(const std::string& path);

/// What the film to go on with says, of that name or, where that has no beginning or no end, the one that it
/// replaced. Throws Error where both are bad.
FilmNotes notes_to_resume(const std::string& path);

/// The film to go on with: as above, where all of it can be read. `fault` is what is wrong with the one of
/// that name, else empty.
struct FilmToResume {
  SavedFilm film;
  std::string fault;
};
FilmToResume open_film_to_resume(const std::string& path, int threads);

/// Throws Error, with what is different, unless a film may go on as the render that the notes are of.
void check_can_resume(const SavedFilm& film, const FilmNotes& here);

/// The film's samples in an empty state of such a render.
void restore(SavedFilm& film, RenderState& state, int threads);

}  // namespace twinray
