// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/measured_media.h"

#include <algorithm>

#include "tests/support/catch.h"

namespace twinray {

TEST_CASE("measured media are known by name, each once, and are media that can be") {
  const std::vector<std::string_view> names = measured_media();
  CHECK(names.size() == 47);
  for (const std::string_view name : names) {
    INFO(name);
    CHECK(std::count(names.begin(), names.end(), name) == 1);
    const MeasuredMedium* const medium = measured_medium(name);
    REQUIRE(medium);
    CHECK(medium->name == name);
    const Rgb both = medium->scattering + medium->absorption;
    CHECK(std::min({both.r, both.g, both.b}) > 0);
    CHECK(max_component(both) < 100);
  }
  CHECK(measured_medium("Wholemilk")->scattering == Rgb{2.55f, 3.21f, 3.77f});
  CHECK(measured_medium("Wholemilk")->absorption == Rgb{0.0011f, 0.0024f, 0.014f});
  // Ketchup is red, for it absorbs all else.
  CHECK(measured_medium("Ketchup")->absorption.r < measured_medium("Ketchup")->absorption.g / 10);
  CHECK(measured_medium("wholemilk") == nullptr);
  CHECK(measured_medium("") == nullptr);
}

}  // namespace twinray
