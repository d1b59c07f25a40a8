// SPDX-License-Identifier: Apache-2.0
// What tests of films and checkpoints have in common.
#pragma once
#include <cstdint>
#include <string>

#include "cli/film/saved_film.h"
#include "tests/support/catch.h"
#include "tests/support/own_scenes.h"
#include "tests/support/process.h"

namespace twinray::test {

/// A small picture of the box by these options.
inline std::string box_words(const std::string& more) { return quoted(box_scene) + " -r 48 36 -q " + more; }

inline void run_well(const std::string& arguments) {
  const ProcessResult result = run_program(arguments);
  INFO(arguments << "\n" << result.err);
  REQUIRE(result.exit_code == 0);
}

/// What it says of an error, without the program's name.
inline std::string told_error(const std::string& arguments) {
  const ProcessResult result = run_program(arguments);
  CHECK(result.exit_code != 0);
  return result.err;
}

inline bool check_says(const std::string& text, const std::string& part) {
  INFO(text);
  const bool found = text.find(part) != std::string::npos;
  CHECK(found);
  return found;
}

/// How many samples its pixels have at most.
inline std::uint32_t samples_in(const std::string& film) { return open_film(film).notes.progress.samples; }

}  // namespace twinray::test
