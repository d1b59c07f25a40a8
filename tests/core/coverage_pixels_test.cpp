// SPDX-License-Identifier: Apache-2.0
#include "core/coverage_pixels.h"

#include "tests/support/catch.h"
#include "tests/support/film.h"

namespace twinray {

TEST_CASE("a film counts the samples of each id, however many there are and in whatever order") {
  const FilmContents contents{{Layer::object_matte}, {}};
  Film film(2, 1, {0, 0, 2, 1}, contents), reversed = film, other = film;
  const std::vector<std::uint32_t> ids{7, 3, 7, 0, 1, 9, 3, 7, 12, 5, 12};
  const auto add = [&](Film& to, std::size_t i) {
    test::add_sample(to, 1, 0, std::uint32_t(i), {{}, {record_id(ids[i])}});
  };
  for (std::size_t i = 0; i < ids.size(); ++i) {
    add(film, i);
    add(reversed, ids.size() - 1 - i);
    add(i < 4 ? other : reversed, i);
  }
  const std::vector<Coverage> expected{{1, 1}, {3, 2}, {5, 1}, {7, 3}, {9, 1}, {12, 2}};
  CHECK(film.coverage(0, 1, 0) == expected);
  CHECK(film.coverage(0, 0, 0).empty());
  film.merge(film);
  reversed.merge(other);
  CHECK(film.coverage(0, 1, 0) == reversed.coverage(0, 1, 0));
  CHECK(film.coverage(0, 1, 0).back() == Coverage{12, 4});
}

}  // namespace twinray
