// SPDX-License-Identifier: Apache-2.0
// Options of engines that have no choice of their own.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/render_command_line.h"
#include "tests/support/catch.h"

namespace twinray::test {

TEST_CASE("the tree of Moller and Trumbore's test is binary, whatever is asked for") {
  const auto parsed = [](const std::string& option) {
    return parse_render_arguments({"a.dae", "--accel=bvh", "--triangle-test=moller-trumbore", option});
  };
  const auto vain = [&](const std::string& option) {
    return fmt::format("{}", fmt::join(parsed(option).without_effect, "\n"));
  };
  CHECK(vain("--max-leaf-size=16") == "");
  CHECK(parsed("--max-leaf-size=16").build.bvh_width == 2);
  CHECK(vain("--bvh-width=8") ==
        "--bvh-width: no effect, for the tree of --triangle-test=moller-trumbore is binary");
  CHECK(vain("--memory-mode=compact") ==
        "--memory-mode: no effect, for the bvh is binary; --bvh-width=8 takes it");
}

}  // namespace twinray::test
