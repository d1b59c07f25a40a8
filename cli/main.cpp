// SPDX-License-Identifier: Apache-2.0
// The program: exceptions become messages and exit codes here, and nowhere else.
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "cli/agreement_command.h"
#include "cli/render_arguments.h"
#include "cli/render_command.h"
#include "core/error.h"

namespace {

int run(const std::string& command, const std::vector<std::string>& words) {
  if (command == "agreement") return twinray::agreement_command(words);
  twinray::render_command(words);
  return 0;
}

std::string usage_line(const std::string& command) {
  return command == "agreement" ? twinray::agreement_usage_line() : twinray::usage_line();
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> words(argv + 1, argv + argc);
  std::string command = "render";  // may be left out
  if (!words.empty() && (words.front() == "render" || words.front() == "agreement")) {
    command = words.front();
    words.erase(words.begin());
  }
  try {
    return run(command, words);
  } catch (const twinray::UsageError& error) {
    fmt::print(stderr, "twinray: {}\n{}\n", error.what(), usage_line(command));
    return 2;
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "twinray: out of memory\n");
    return 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "twinray: {}\n", error.what());
    return 1;
  }
}
