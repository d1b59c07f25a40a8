// SPDX-License-Identifier: Apache-2.0
// The program: exceptions become messages and exit codes here, and nowhere else.
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "cli/render_arguments.h"
#include "cli/render_command.h"
#include "core/error.h"

int main(int argc, char** argv) {
  std::vector<std::string> words(argv + 1, argv + argc);
  if (!words.empty() && words.front() == "render") words.erase(words.begin());
  try {
    twinray::render_command(words);
    return 0;
  } catch (const twinray::UsageError& error) {
    fmt::print(stderr, "twinray: {}\n{}\n", error.what(), twinray::usage_line());
    return 2;
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "twinray: out of memory\n");
    return 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "twinray: {}\n", error.what());
    return 1;
  }
}
