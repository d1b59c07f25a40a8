// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "core/film.h"

namespace twinray::test {

/// What one sample brings to a film.
struct FilmSample {
  Rgb color;
  std::vector<Rgb> layers;                   ///< In the film's order.
  std::vector<Rgb> paths = {}, groups = {};  ///< Parts of the light, where the film keeps them.
};

inline bool add_sample(Film& film, int x, int y, std::uint32_t index, const FilmSample& sample) {
  Records records(film.contents(), 1);
  const RecordSpans spans = records.spans(1);
  spans.color()[0] = sample.color;
  for (std::size_t i = 0; i < sample.layers.size(); ++i)
    if (spans.has(film.layers()[i])) spans[film.layers()[i]][0] = sample.layers[i];
  const auto write = [&](Division division, const std::vector<Rgb>& parts) {
    if (spans.has(division)) std::copy(parts.begin(), parts.end(), spans[division][0].begin());
  };
  write(Division::paths, sample.paths);
  write(Division::groups, sample.groups);
  return film.add(x, y, index, spans, 0);
}

/// The parts of a pixel's light.
inline std::vector<Rgb> parts_at(const Film& film, Division division, int x, int y) {
  std::vector<Rgb> parts(film.contents().parts[std::size_t(division)]);
  film.read_parts(division, x, y, parts);
  return parts;
}

}  // namespace twinray::test
