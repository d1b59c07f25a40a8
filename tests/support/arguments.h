// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <utility>
#include <vector>

#include "cli/render_command_line.h"
#include "core/error.h"
#include "tests/support/catch.h"

namespace twinray::test {

/// What these words ask for of a scene.
inline RenderArguments parse(std::vector<std::string> words) {
  words.push_back("scene.dae");
  return parse_render_arguments(words);
}

/// Why they are refused; "accepted" where they are not.
inline std::string message_of(std::vector<std::string> words) {
  try {
    parse(std::move(words));
  } catch (const UsageError& error) {
    return error.what();
  }
  return "accepted";
}

/// What is said of options that change nothing, one after the other. Strict runs must refuse the first.
inline std::string no_effect(std::vector<std::string> words) {
  const std::vector<std::string> said = parse(words).without_effect;
  words.push_back("--strict");
  CHECK(message_of(words) == (said.empty() ? "accepted" : said.front()));
  return fmt::format("{}", fmt::join(said, "\n"));
}

}  // namespace twinray::test
