// SPDX-License-Identifier: Apache-2.0
// What a film file says of the render that its samples come from (docs/films.md).
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/input_files.h"
#include "cli/options/options.h"
#include "cli/picture_metadata.h"
#include "integrators/render.h"

namespace twinray {

/// What decides about the bits of every sample. Renders of which all of this is equal can go on with each
/// other's films, and be merged.
struct RenderIdentity {
  std::string program;  ///< Its name and version.
  InputFiles files;
  std::map<std::string, Words> options;  ///< Those of the options given that change samples.
  int width = 0, height = 0;             ///< Of the frame.
  PixelRect window;                      ///< The picture's pixels.

  bool operator==(const RenderIdentity&) const = default;
};

/// How far the render was, as in RenderState.
struct FilmProgress {
  RayCounts rays;
  std::uint32_t samples = 0, next_estimate = 0;
  std::optional<double> error;
  double seconds = 0;
};

struct FilmNotes {
  RenderIdentity identity;
  std::uint32_t samples = 1;         ///< Of the whole picture.
  std::optional<SampleRange> range;  ///< Those of them that are in the film, once it is complete,
  std::optional<TileRange> tiles;    ///< or its tiles; else all.
  FilmProgress progress;
  bool is_complete = false;
  Words words;         ///< Of the command line.
  std::string folder;  ///< Where it was called.
  PictureNotes picture;
};

std::string film_notes_json(const FilmNotes& notes);
/// Throws Error where this is no such text.
FilmNotes parse_film_notes(const std::string& json);

/// Of the first option that is not the same: "its --seed is 3, and 4 here"; empty: all are. `other` is what
/// the others are called ("here", "there").
std::string option_difference(const std::map<std::string, Words>& film,
                              const std::map<std::string, Words>& others, const char* other);

/// What keeps the film of a render out of another one, which is called `other` ("here", "there"): "its --seed
/// is 3, and 4 here"; empty: nothing.
std::string difference(const RenderIdentity& film, const RenderIdentity& other_render, const char* other);

/// "samples 0:16 of 64"
std::string part_text(const FilmNotes& notes);

}  // namespace twinray
