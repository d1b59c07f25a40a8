// SPDX-License-Identifier: Apache-2.0
// The command lines of write-ups of CS184's assignment, run by our program under that name.
#pragma once
#include <string>
#include <vector>

namespace twinray::bench {

struct WriteUpOptions {
  std::string folder;  ///< With the scene files, searched with all below it.
  int rounds = 3;
  bool is_quick = false;          ///< Only lines that take seconds.
  std::vector<std::string> only;  ///< Regular expressions; where there are some, a line must match one.
};

/// Runs every line in turn, `rounds` times, and gives a table in Markdown: medians of what the program
/// printed and of its CPU time, beside the times that the write-ups report. `report` is told what is being
/// done. Throws Error where the program fails.
std::string write_up_table(const WriteUpOptions& options, void (*report)(const std::string&));

}  // namespace twinray::bench
