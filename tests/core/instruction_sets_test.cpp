// SPDX-License-Identifier: Apache-2.0
#include "core/instruction_sets.h"

#include <hwy/targets.h>

#include "tests/support/catch.h"

namespace twinray {

TEST_CASE("this machine has the instruction sets that Highway's library finds") {
  constexpr std::int64_t ours = HWY_AVX3 | HWY_AVX2 | HWY_SSE4 | HWY_NEON;
  CHECK(supported_targets() == (std::int64_t(hwy::SupportedTargets()) & HWY_TARGETS & ours));
  CHECK(supported_targets() != 0);  // As on all machines that tests run on.
}

}  // namespace twinray
