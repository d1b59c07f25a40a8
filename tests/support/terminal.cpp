// SPDX-License-Identifier: Apache-2.0
#include "tests/support/terminal.h"

#include <pty.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <stdexcept>
#include <utility>

namespace twinray::test {
namespace {

[[noreturn]] void become(const std::vector<std::string>& words, const std::vector<std::string>& environment) {
  for (const std::string& variable : environment) {
    const std::size_t equals = variable.find('=');
    setenv(variable.substr(0, equals).c_str(), variable.substr(equals + 1).c_str(), 1);
  }
  std::vector<char*> arguments{const_cast<char*>("twinray")};
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  signal(SIGINT, SIG_DFL);
  execv(TWINRAY_PROGRAM, arguments.data());
  _exit(127);
}

}  // namespace

TerminalProgram::TerminalProgram(const std::vector<std::string>& words,
                                 const std::vector<std::string>& environment) {
  process_ = forkpty(&terminal_, nullptr, nullptr, nullptr);
  if (process_ < 0) throw std::runtime_error("no terminal can be made");
  if (process_ == 0) become(words, environment);
}

TerminalProgram::~TerminalProgram() {
  if (process_ > 0) {
    kill(process_, SIGKILL);
    exit_code();
  }
  close(terminal_);
}

bool TerminalProgram::wait_for(const std::string& text) {
  while (shown_.find(text) == std::string::npos)
    if (!read_more()) return false;
  return true;
}

void TerminalProgram::press_control_c() {
  const char control_c = '\x03';
  if (write(terminal_, &control_c, 1) != 1) throw std::runtime_error("the terminal is closed");
}

void TerminalProgram::send(int signal_number) { kill(process_, signal_number); }

int TerminalProgram::exit_code() {
  while (read_more()) {
  }
  int status = 0;
  waitpid(std::exchange(process_, -1), &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

bool TerminalProgram::read_more() {
  char bytes[4096];
  const ssize_t count = read(terminal_, bytes, sizeof bytes);
  if (count <= 0) return false;  // At the program's end the terminal gives an error.
  shown_.append(bytes, std::size_t(count));
  return true;
}

}  // namespace twinray::test
