// SPDX-License-Identifier: Apache-2.0
// The program: exceptions become messages and exit codes here, and nowhere else.
#include <algorithm>
#include <array>
#include <exception>
#include <string>
#include <vector>

#include "cli/agreement_command.h"
#include "cli/console.h"
#include "cli/crosscheck_arguments.h"
#include "cli/crosscheck_command.h"
#include "cli/render_arguments.h"
#include "cli/render_command.h"
#include "cli/stats_command.h"
#include "core/error.h"

namespace {

using Words = std::vector<std::string>;

struct Command {
  const char* name;
  int (*run)(const Words&);
  std::string (*usage_line)();
};

constexpr std::array commands{
    Command{"render", twinray::render_command, twinray::usage_line},  // may be left out
    Command{"agreement", twinray::agreement_command, twinray::agreement_usage_line},
    Command{"crosscheck", twinray::crosscheck_command, twinray::crosscheck_usage_line},
    Command{"stats", twinray::stats_command, twinray::stats_usage_line}};

/// The command that the first word names, which is taken away; render where it names none.
const Command& take_command(Words& words) {
  const auto named = std::find_if(commands.begin(), commands.end(), [&](const Command& command) {
    return !words.empty() && words.front() == command.name;
  });
  if (named == commands.end()) return commands.front();
  words.erase(words.begin());
  return *named;
}

/// The command's exit code; what it throws becomes words.
int run(const Command& command, const Words& words) {
  namespace console = twinray::console;
  try {
    return command.run(words);
  } catch (const twinray::UsageError& error) {
    console::print_error("twinray: {}\n{}\n", error.what(), command.usage_line());
    return 2;
  } catch (const std::bad_alloc&) {
    console::write_error("twinray: out of memory\n");
    return 1;
  } catch (const std::exception& error) {
    console::print_error("twinray: {}\n", error.what());
    return 1;
  }
}

}  // namespace

int main(int argc, char** argv) {
  twinray::console::open();
  Words words(argv + 1, argv + argc);
  const Command& command = take_command(words);
  return twinray::console::finish(run(command, words));
}
