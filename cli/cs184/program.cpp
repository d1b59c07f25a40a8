// SPDX-License-Identifier: Apache-2.0
#include "cli/cs184/program.h"

#include <CLI/CLI.hpp>
#include <ctime>

#include "cli/console.h"
#include "cli/cs184/options.h"
#include "cli/cs184/screenshot_name.h"
#include "cli/cs184/talk.h"
#include "cli/render_command.h"
#include "cli/version.h"

namespace twinray {
namespace {

std::tm local_time() {
  const std::time_t now = std::time(nullptr);
  std::tm time{};
  localtime_r(&now, &time);
  return time;
}

/// Where CS184's program opens a window, the picture goes to a file with the name of its screenshots.
void name_screenshot(RenderArguments& arguments) {
  arguments.output = screenshot_name(arguments.scene, local_time());
  console::print_error("[PathTracer] There is no -f, and this program opens no window: it renders to {}\n",
                       arguments.output);
}

int render_cs184(RenderArguments arguments, const Words& words) {
  if (arguments.replay) arguments.quiet = false;  // What is written of a path is all that is made.
  if (arguments.output.empty() && !arguments.replay) name_screenshot(arguments);
  Cs184Talk talk(arguments);
  return render_command(arguments, words, talk);
}

}  // namespace

int run_cs184(const std::string& path, const Words& words) {
  try {
    return render_cs184(parse_cs184_arguments(words), words);
  } catch (const CLI::CallForHelp&) {
    console::write(cs184_usage(path));
    return 0;
  } catch (const CLI::CallForVersion&) {
    console::write(version_text());
    return 0;
  } catch (const UsageError&) {
    console::write(cs184_usage(path));
    throw;
  }
}

}  // namespace twinray
