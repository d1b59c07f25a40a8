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

/// Writes the sample into a record for the film.
inline void write_record(const Film& film, const FilmSample& sample, const RecordSpans& spans,
                         std::size_t i) {
  spans.color()[i] = sample.color;
  for (std::size_t layer = 0; layer < sample.layers.size(); ++layer)
    if (spans.has(film.layers()[layer])) spans[film.layers()[layer]][i] = sample.layers[layer];
  const auto write = [&](Division division, const std::vector<Rgb>& parts) {
    if (spans.has(division)) std::copy(parts.begin(), parts.end(), spans[division][i].begin());
  };
  write(Division::paths, sample.paths);
  write(Division::groups, sample.groups);
}

inline bool add_sample(Film& film, int x, int y, std::uint32_t index, const FilmSample& sample) {
  Records records(film.contents(), 1);
  write_record(film, sample, records.spans(1), 0);
  return film.add(x, y, index, records.spans(1), 0);
}

/// The parts of a pixel's light.
inline std::vector<Rgb> parts_at(const Film& film, Division division, int x, int y) {
  std::vector<Rgb> parts(film.contents().parts[std::size_t(division)]);
  film.read_parts(division, x, y, parts);
  return parts;
}

}  // namespace twinray::test
