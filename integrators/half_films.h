// SPDX-License-Identifier: Apache-2.0
// The samples of a picture in two halves, each a film: exact, mergeable, in any order, as the film of all is.
#pragma once
#include <bit>
#include <cstddef>
#include <cstdint>

#include "core/film.h"

namespace twinray {

/// To which half a sample belongs: that of the binary digit after the first of its index. So each half has
/// blocks of 2^k successive samples, aligned, which a sampler stratifies as well as those of the whole: the
/// halves differ by little more than the noise of the picture. Even and odd indices would differ by several
/// times that. Of 2^k samples each half has as many; of others one has a third of them at least.
constexpr std::size_t half_of(std::uint32_t sample_index) {
  return sample_index < 2 ? sample_index
                          : std::size_t((sample_index & std::bit_floor(sample_index) / 2) != 0);
}

struct HalfFilms {
  Film first, second;

  /// The half to which a sample belongs.
  Film& of(std::uint32_t sample_index) { return half_of(sample_index) == 0 ? first : second; }
};

/// Empty films of the same frame as another.
inline HalfFilms half_films(const Film& film, const FilmContents& contents) {
  const Film empty(film.frame_width(), film.frame_height(), film.window(), contents);
  return {empty, empty};
}

}  // namespace twinray
