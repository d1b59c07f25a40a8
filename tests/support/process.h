// SPDX-License-Identifier: Apache-2.0
// Running the program as a user does.
#pragma once
#include <string>

namespace twinray::test {

/// A path as one word of the shell; it must not have a ' itself.
std::string quoted(const std::string& path);

struct ProcessResult {
  int exit_code = -1;
  std::string out, err;
};

/// Before a command: root may read and write any folder, unless it gives up that right.
std::string without_rights();

/// Runs a command of the shell; what it redirects itself does not arrive here.
ProcessResult run_shell(const std::string& command);

/// Runs the program that was built beside the tests; `arguments` goes through the shell, after
/// `environment` ("NAME=value ...").
ProcessResult run_program(const std::string& arguments, const std::string& environment = "");

}  // namespace twinray::test
