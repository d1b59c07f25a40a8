// SPDX-License-Identifier: Apache-2.0
// Which files a process may still reach, by Landlock (Linux 5.13 and later).
#pragma once
#include <string>
#include <vector>

namespace twinray {

/// Places that stay open to a process: files, or folders with all that is in them. What does not exist is
/// left out.
struct OpenPlaces {
  std::vector<std::string> read;
  std::vector<std::string> write;    ///< Files are made, replaced and removed there, but not read.
  std::vector<std::string> scratch;  ///< Files are made there, and read again.
};

/// Closes all other files to the calling thread and to those that it begins, for good: nothing else is
/// opened, made, removed or executed. Files that are open stay so; names, sizes and times can still be asked
/// for. False where the kernel has no Landlock; nothing is closed then. Throws Error where it refuses.
bool close_files(const OpenPlaces& places);

}  // namespace twinray
