// SPDX-License-Identifier: Apache-2.0
// Which films make a picture together.
#pragma once
#include <string>
#include <vector>

#include "cli/film/saved_film.h"

namespace twinray {

/// A film of several that are merged, without its samples.
struct FilmPart {
  std::string path;
  FilmNotes notes;
  std::vector<FilmContents> contents;
  std::uint64_t content = 0;  ///< Equal where the samples are.
};

/// Whether the second film's samples begin where the first one's end.
bool is_next(const FilmPart& a, const FilmPart& b);

/// Films whose samples are those of one render, none twice.
struct FilmParts {
  std::vector<FilmPart> parts;        ///< In the order of their ranges; one at least.
  std::vector<std::string> repeated;  ///< Files with the samples of another one.
  std::vector<std::string> missing;   ///< "samples 16 to 32 of 64": what no film has.
  bool is_by_tiles = false;
  std::uint32_t begin = 0, end = 0;  ///< Of all ranges together.
};

/// Reads the beginning and the end of each film. Throws Error, with the names, where films are of different
/// renders, are not done, overlap, or have the same samples with other sums; and for a gap, unless
/// `gaps_allowed`.
enum class Gaps { refused, allowed };
FilmParts read_film_parts(const std::vector<std::string>& paths, Gaps gaps);

/// The films of all parts added up, of the whole picture's window.
RenderState merged(const FilmParts& parts, int threads);

}  // namespace twinray
