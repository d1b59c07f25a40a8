// SPDX-License-Identifier: Apache-2.0
#include "cli/film/film_notes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace twinray {
namespace {

std::string value_text(const Words& words) { return fmt::format("{}", fmt::join(words, " ")); }

/// Of the first option that is not the same.
std::string option_difference(const std::map<std::string, Words>& film,
                              const std::map<std::string, Words>& here) {
  for (const auto& [name, words] : film) {
    const auto found = here.find(name);
    if (found == here.end()) return fmt::format("it was made with {} {}", name, value_text(words));
    if (found->second != words)
      return fmt::format("its {} is {}, and {} here", name, value_text(words), value_text(found->second));
  }
  for (const auto& [name, words] : here)
    if (!film.contains(name)) return fmt::format("it was made without {} {}", name, value_text(words));
  return "";
}

std::string file_difference(const std::map<std::string, std::string>& film,
                            const std::map<std::string, std::string>& here) {
  for (const auto& [name, hash] : film) {
    const auto found = here.find(name);
    if (found == here.end()) return fmt::format("its scene reads {}, which is not read here", name);
    if (found->second != hash) return fmt::format("{} is not the file that it was", name);
  }
  for (const auto& [name, hash] : here)
    if (!film.contains(name)) return fmt::format("its scene does not read {}", name);
  return "";
}

std::string window_text(const RenderIdentity& identity) {
  const auto& [x0, y0, x1, y1] = identity.window;
  return fmt::format("x {} to {}, y {} to {} of {} x {} pixels", x0, x1, y0, y1, identity.width,
                     identity.height);
}

}  // namespace

std::string difference(const RenderIdentity& film, const RenderIdentity& here) {
  if (film.program != here.program)
    return fmt::format("it was made by {}, and this is {}", film.program, here.program);
  if (std::string files = file_difference(film.files, here.files); !files.empty()) return files;
  if (std::string options = option_difference(film.options, here.options); !options.empty()) return options;
  if (film.width != here.width || film.height != here.height || film.window != here.window)
    return fmt::format("it shows {}, and here are {}", window_text(film), window_text(here));
  return "";
}

std::string part_text(const FilmNotes& notes) {
  if (notes.tiles)
    return fmt::format("tiles {} to {} of {}", notes.tiles->begin, notes.tiles->end,
                       tile_grid(notes.identity.window, tile_size).count());
  const SampleRange range = notes.range.value_or(SampleRange{0, notes.samples});
  return fmt::format("samples {} to {} of {}", range.begin, range.end, notes.samples);
}

}  // namespace twinray
