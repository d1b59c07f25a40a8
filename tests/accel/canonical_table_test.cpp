// SPDX-License-Identifier: Apache-2.0
#include "tests/accel/canonical_table.h"

#include "tests/support/catch.h"

namespace twinray {

TEST_CASE("every canonical engine gives the bits of the table") {
  for (const Backend backend : available_backends()) {
    if (backend == Backend::embree_native) continue;
    INFO(backend_name(backend));
    CHECK(test::canonical_mismatches(backend) == std::vector<std::string>{});
  }
}

}  // namespace twinray
