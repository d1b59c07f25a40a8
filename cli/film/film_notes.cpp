// SPDX-License-Identifier: Apache-2.0
#include "cli/film/film_notes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace twinray {
namespace {

std::string value_text(const Words& words) { return fmt::format("{}", fmt::join(words, " ")); }

std::string window_text(const RenderIdentity& identity) {
  const auto& [x0, y0, x1, y1] = identity.window;
  return fmt::format("x {} to {}, y {} to {} of {} x {} pixels", x0, x1, y0, y1, identity.width,
                     identity.height);
}

}  // namespace

std::string option_difference(const std::map<std::string, Words>& film,
                              const std::map<std::string, Words>& others, const char* other) {
  for (const auto& [name, words] : film) {
    const auto found = others.find(name);
    if (found == others.end()) return fmt::format("it was made with {} {}", name, value_text(words));
    if (found->second != words)
      return fmt::format("its {} is {}, and {} {}", name, value_text(words), value_text(found->second),
                         other);
  }
  for (const auto& [name, words] : others)
    if (!film.contains(name)) return fmt::format("it was made without {} {}", name, value_text(words));
  return "";
}

std::string difference(const RenderIdentity& film, const RenderIdentity& other_render, const char* other) {
  if (film.program != other_render.program)
    return fmt::format("it was made by {}, and {} is {}", film.program, other, other_render.program);
  if (std::string files = file_difference(film.files, other_render.files, other); !files.empty())
    return files;
  if (std::string options = option_difference(film.options, other_render.options, other); !options.empty())
    return options;
  if (film.width != other_render.width || film.height != other_render.height ||
      film.window != other_render.window)
    return fmt::format("it shows {}, and {} are {}", window_text(film), other, window_text(other_render));
  return "";
}

std::string part_text(const FilmNotes& notes) {
  if (notes.tiles)
    return fmt::format("tiles {}:{} of {}", notes.tiles->begin, notes.tiles->end,
                       tile_grid(notes.identity.window, tile_size).count());
  const SampleRange range = notes.range.value_or(SampleRange{0, notes.samples});
  return fmt::format("samples {}:{} of {}", range.begin, range.end, notes.samples);
}

}  // namespace twinray
