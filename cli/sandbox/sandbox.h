// SPDX-License-Identifier: Apache-2.0
// What a process may do whose input is not trusted: a scene, or a picture, may be from anybody.
#pragma once
#include <string>
#include <vector>

#include "cli/sandbox/files.h"
#include "cli/sandbox/system_calls.h"

namespace twinray {

/// What the work in a sandbox needs, besides the system's libraries.
struct SandboxNeeds {
  OpenPlaces places;
  Network network = Network::closed;
  bool strict = false;  ///< What the kernel cannot close is an error, and no warning.
};

/// The folder that a file lies in: "." of a name alone.
std::string folder_of(const std::string& path);

/// The places of a list, as PATH has them: "a:b"; empty ones are none.
std::vector<std::string> places_in(const std::string& list);

/// Throws Error where one of the places that --sandbox names does not exist.
void check_places(const std::vector<std::string>& places);

/// Closes to the process all that the work does not need. Throws Error where the process has another thread.
/// Returns what is open, in a line.
std::string enter_sandbox(const SandboxNeeds& needs);

}  // namespace twinray
