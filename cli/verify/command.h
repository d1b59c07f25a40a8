// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cli/options/limits.h"
#include "cli/options/options.h"

namespace twinray {

/// What a verify command line asks for.
struct VerifyArguments {
  std::string picture;
  std::string scene;                  ///< In place of the one that the picture names; empty: that one.
  std::uint32_t tiles = 16;           ///< How many are rendered again, at most.
  std::optional<std::uint64_t> seed;  ///< Which; not set: others each time.
  std::string accel;                  ///< The engine; empty: another one than made the picture.
  /// Further places that may be read where the picture is not trusted; not set: it is.
  std::optional<std::vector<std::string>> sandbox;
  ProcessLimits limits;
  int threads = 0;
  bool quiet = false;
};

/// Adds the command's options; the function that is returned gives what they ask for, once they are read.
std::function<VerifyArguments()> add_verify_options(CLI::App& app);

/// twinray verify PICTURE [options]: whether pixels are those of the scene and the command that the metadata
/// name. Returns the exit code: 0 if all that were looked at have the same bits, else 1. Throws Error for a
/// picture of which that cannot be said.
int verify_command(const VerifyArguments& arguments);

}  // namespace twinray
