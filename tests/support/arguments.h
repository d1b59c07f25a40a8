// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "cli/render_command_line.h"
#include "core/error.h"

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

}  // namespace twinray::test
