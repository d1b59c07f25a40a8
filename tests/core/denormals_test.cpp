// SPDX-License-Identifier: Apache-2.0
#include "core/denormals.h"

#include "tests/support/catch.h"
#include "tests/support/flush_denormals.h"

namespace twinray {

TEST_CASE("a thread that flushes denormal numbers is known by its mode, and by what it computes") {
  const auto check = [](bool are_kept) {
    CHECK(computes_denormals() == are_kept);
    CHECK(mode_keeps_denormals() == are_kept);
    CHECK(keeps_denormals() == are_kept);
  };
  check(true);
  for (const auto which : {test::FlushDenormals::results, test::FlushDenormals::operands}) {
    const test::FlushDenormals flush(which);
    check(false);
  }
  check(true);
}

}  // namespace twinray
