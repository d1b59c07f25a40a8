// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "core/columns.h"
#include "core/film.h"

namespace twinray::test {

/// All that a film holds: equal where films are, in every layer and every part of the light.
inline std::vector<std::byte> bytes_of(const Film& film) {
  ColumnWriter writer;
  film.save(film.window().y0, film.window().y1, writer);
  return writer.bytes();
}

}  // namespace twinray::test
