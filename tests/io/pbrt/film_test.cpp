// SPDX-License-Identifier: Apache-2.0
// What a pbrt file says of its picture.
#include <fmt/format.h>

#include "tests/support/catch.h"
#include "tests/support/pbrt_text.h"

namespace twinray {

using test::load_pbrt_text;

TEST_CASE("settings of pbrt that change its picture and are options here are told") {
  const auto warning = [](const std::string& statements) {
    const auto warnings = load_pbrt_text(statements + " WorldBegin").warnings;
    return warnings.empty() ? "" : warnings.at(0).message;
  };
  CHECK(warning("Film \"rgb\" \"float maxcomponentvalue\" 10") ==
        "\"maxcomponentvalue\" is not heeded; --clamp limits indirect light");
  CHECK(warning("Integrator \"path\" \"bool regularize\" true") ==
        "\"regularize\" is an option here: --regularize");
  CHECK(warning("Integrator \"path\" \"bool regularize\" false") == "");
}

TEST_CASE("a film's white balance says which daylight is white, where it is one that can be shown") {
  const auto loaded = [](const std::string& kelvin) {
    return load_pbrt_text("Film \"rgb\" \"float whitebalance\" " + kelvin + " WorldBegin");
  };
  const LoadedScene balanced = loaded("4500");
  CHECK(balanced.warnings.empty());
  CHECK(balanced.defaults.daylight_kelvin == 4500.0);
  CHECK(balanced.summary.notes ==
        std::vector<std::string>{"in pictures of 8 bits daylight of 4500 K is white, as the film says; "
                                 "--white-balance is another one, and floats keep the light"});
  CHECK_FALSE(loaded("0").defaults.daylight_kelvin);
  for (const char* kelvin : {"1999", "25001", "-5000"}) {
    const LoadedScene other = loaded(kelvin);
    CHECK_FALSE(other.defaults.daylight_kelvin);
    REQUIRE(other.warnings.size() == 1);
    CHECK(other.warnings[0].message ==
          fmt::format("a white balance of {} K is not rendered; valid are 2000 to 25000", kelvin));
  }
}

}  // namespace twinray
