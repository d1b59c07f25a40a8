// SPDX-License-Identifier: Apache-2.0
// How a film file begins: what films it holds, and whatever its writer wants to know again, as JSON.
#pragma once
#include <string>
#include <vector>

#include "core/film.h"

namespace twinray {

/// Films of one frame and window.
struct FilmHeader {
  int frame_width = 0, frame_height = 0;
  PixelRect window;
  std::vector<FilmContents> films;  ///< What each of them keeps.
  std::string notes = "{}";         ///< A JSON object.

  /// Empty films as they are described.
  std::vector<Film> make_films() const;
  bool operator==(const FilmHeader&) const = default;
};

std::string film_header_json(const FilmHeader& header);
/// Throws Error, with what is missing or wrong.
FilmHeader parse_film_header(const std::string& json);

}  // namespace twinray
