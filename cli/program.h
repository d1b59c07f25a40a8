// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>
#include <string>
#include <vector>

namespace twinray {

/// How the program was called.
struct Invocation {
  std::string path;                ///< As it was typed.
  std::string name;                ///< "twinray" or "pathtracer": who speaks in messages.
  std::vector<std::string> words;  ///< Behind the program's name, but for --cs184.
  bool is_cs184 = false;           ///< Behaves as CS184's program (docs/cs184.md).
};

/// The program behaves as CS184's where it is called `pathtracer`, or with --cs184 among the words of a
/// render.
Invocation read_invocation(std::span<const char* const> arguments);

/// Runs CS184's program, or the subcommand that the first word names; render where it names none. Returns the
/// exit code. Throws UsageError, with the subcommand's usage line below the reason, and Error.
int run_program(const Invocation& invocation);

}  // namespace twinray
