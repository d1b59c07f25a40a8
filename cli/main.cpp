// SPDX-License-Identifier: Apache-2.0
// The program: exceptions become messages and exit codes here, and nowhere else.
#include <exception>
#include <new>

#include "cli/console.h"
#include "cli/program.h"
#include "core/error.h"

namespace {

namespace console = twinray::console;

int fail(const char* reason, int exit_code) {
  console::print_error("twinray: {}\n", reason);
  return exit_code;
}

int run(int argc, char** argv) {
  try {
    return twinray::run_program({argv + 1, argv + argc});
  } catch (const twinray::UsageError& error) {
    return fail(error.what(), 2);
  } catch (const std::bad_alloc&) {
    return fail("out of memory", 1);
  } catch (const std::exception& error) {
    return fail(error.what(), 1);
  }
}

}  // namespace

int main(int argc, char** argv) {
  console::open();
  return console::finish(run(argc, argv));
}
