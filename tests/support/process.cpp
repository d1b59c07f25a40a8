// SPDX-License-Identifier: Apache-2.0
#include "tests/support/process.h"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>

#include "tests/support/temporary_folder.h"

namespace twinray::test {

std::string quoted(const std::string& path) { return "'" + path + "'"; }

std::string without_rights() { return geteuid() == 0 ? "setpriv --bounding-set=-all --inh-caps=-all " : ""; }

ProcessResult run_shell(const std::string& shell_command) {
  const TemporaryFolder folder;
  const std::string out = folder.file("out"), err = folder.file("err");
  const std::string command = "(" + shell_command + ") >'" + out + "' 2>'" + err + "'";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), read_text(out), read_text(err)};
}

ProcessResult run_program(const std::string& arguments, const std::string& environment) {
  return run_shell(environment + " '" TWINRAY_PROGRAM "' " + arguments);
}

}  // namespace twinray::test
