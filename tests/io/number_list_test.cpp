// SPDX-License-Identifier: Apache-2.0
#include "io/number_list.h"

#include "tests/support/catch.h"

namespace twinray {
namespace {

std::string problem_with(std::string_view text) {
  try {
    parse_doubles(text);
  } catch (const NumberError& error) {
    return std::to_string(error.offset) + ": " + error.message;
  }
  return "";
}

}  // namespace

TEST_CASE("numbers are read over any white space") {
  CHECK(parse_doubles(" 1\t-2.5\r\n+3e2 .5 ") == std::vector<double>{1, -2.5, 300, 0.5});
  CHECK(parse_doubles(" \n ").empty());
}

TEST_CASE("a float is rounded once from its text") {
  // Just above the middle of 1 and the next float; its double is that middle, which would round to even.
  CHECK(parse_floats("1.00000005960464477540")[0] == 0x1.000002p0f);
}

TEST_CASE("a number too small for its type is zero") {
  CHECK(parse_floats("1e-60 -1e-60") == std::vector<float>{0, 0});
  CHECK(parse_doubles("1e-400")[0] == 0);
}

TEST_CASE("what is no finite decimal number is named with its offset") {
  CHECK(problem_with("1 1,5") ==
        "2: \"1,5\" is not a number: decimals have a point, and numbers are separated by spaces");
  CHECK(problem_with("0x10") ==
        "0: \"0x10\" is not a number; valid are decimal numbers such as -1.5 or 2e-3");
  CHECK(problem_with("1.5f") ==
        "0: \"1.5f\" is not a number; valid are decimal numbers such as -1.5 or 2e-3");
  CHECK(problem_with("+-1") == "0: \"+-1\" is not a number; valid are decimal numbers such as -1.5 or 2e-3");
  CHECK(problem_with("nan") == "0: \"nan\" is not finite; every number must be");
  CHECK(problem_with("-inf") == "0: \"-inf\" is not finite; every number must be");
  CHECK(problem_with("1e400") == "0: \"1e400\" is too large; numbers lie within +-1.8e+308");
}

TEST_CASE("a float beyond the floats is too large, though a double has it") {
  CHECK_THROWS_AS(parse_floats("1e39"), NumberError);
  CHECK(parse_doubles("1e39")[0] == 1e39);
}

TEST_CASE("an index is a whole number of 32 bits") {
  CHECK(parse_indices("0 4294967295") == std::vector<std::uint32_t>{0, 4294967295u});
  for (const char* wrong : {"-1", "1.0", "4294967296", "+1", "x"})
    CHECK_THROWS_AS(parse_indices(wrong), NumberError);
}

TEST_CASE("a token is found by its index") {
  CHECK(token_offset("  10 20\n30", 0) == 2);
  CHECK(token_offset("  10 20\n30", 2) == 8);
  CHECK(token_offset("  10 20\n30", 3) == 10);
}

}  // namespace twinray
