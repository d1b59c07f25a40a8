// SPDX-License-Identifier: Apache-2.0
// Which films make a picture together.
#pragma once
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "cli/film/saved_film.h"

namespace twinray {

/// A film of several that are merged: what is its own.
struct FilmPart {
  std::string path;
  std::uint32_t begin = 0, end = 0;  ///< Of its samples, or tiles.
  FilmProgress progress;
  std::uint64_t content = 0;  ///< Equal where the sums are.
  Words words;                ///< Of its command line.
};

/// Films whose samples are those of one render, none twice.
struct FilmParts {
  FilmNotes notes;                     ///< Those of the first film that was named: what all have in common.
  std::vector<FilmContents> contents;  ///< Of each film file.
  std::vector<FilmPart> parts;         ///< In the order of their ranges; one at least.
  std::set<std::string> engines;       ///< That made them.
  std::vector<std::string> repeated;   ///< Files with the samples of another one.
  std::vector<std::string> missing;    ///< "samples 16:32 of 64": what no film has.

  bool are_tiles() const { return notes.tiles.has_value(); }
  /// How many samples or tiles the whole picture has.
  std::uint32_t whole() const;
  /// Whether something is missing between two parts.
  bool has_inner_gap() const;
};

enum class Gaps { refused, allowed };

/// Reads the beginning and the end of each film; of 10^4 films a few kilobytes each stay in memory at most.
/// Throws Error, with the names, where films are of different renders, are not done, overlap, or have the
/// same samples with other sums; and for a gap, unless these are allowed.
FilmParts read_film_parts(const std::vector<std::string>& paths, Gaps gaps);

/// The films of all parts added up, of the whole picture's window.
RenderState merged(const FilmParts& parts, int threads);

}  // namespace twinray
