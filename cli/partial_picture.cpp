// SPDX-License-Identifier: Apache-2.0
#include "cli/partial_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "cli/outputs.h"
#include "io/destination.h"

namespace twinray {
namespace {

struct CountRange {
  std::uint32_t least = std::numeric_limits<std::uint32_t>::max(), most = 0;
};

CountRange count_range(const Film& film) {
  CountRange range;
  const PixelRect& window = film.window();
  for (int y = window.y0; y < window.y1; ++y)
    for (int x = window.x0; x < window.x1; ++x) {
      const PixelSums& pixel = film.pixel(x, y);
      range.least = std::min(range.least, pixel.count + pixel.rejected);
      range.most = std::max(range.most, pixel.count + pixel.rejected);
    }
  return range;
}

}  // namespace

RenderOutputs partial_outputs(const RenderOutputs& outputs) {
  if (!outputs.film.empty()) return {.film = partial_name(outputs.film)};
  if (destination_of(outputs.picture).kind != Destination::Kind::file) return {};
  return {.picture = partial_name(outputs.picture),
          .rates = partial_name(outputs.rates),
          .legend = partial_name(outputs.legend)};
}

std::string sample_range_text(const Film& film, std::uint32_t wanted) {
  const auto [least, most] = count_range(film);
  std::string text = least == most ? fmt::format("{}", most) : fmt::format("{} to {}", least, most);
  if (wanted < Film::max_samples) text += fmt::format(" of {}", wanted);
  return text;
}

std::string write_partial(const RenderOutputs& partial, const RenderArguments& arguments, const Film& film,
                          PictureNotes notes) {
  if (count_range(film).most == 0) return "there is no sample yet; no picture is written";
  const std::string samples = sample_range_text(film, arguments.render.samples);
  set_value(notes.metadata, "twinray:samples", samples);
  write_pictures(partial, arguments, {film}, notes);
  return fmt::format("{} holds what there is: {} samples a pixel", partial.picture, samples);
}

}  // namespace twinray
