// SPDX-License-Identifier: Apache-2.0
// The program: exceptions become messages and exit codes here, and nowhere else.
#include <exception>
#include <new>
#include <string>

#include "cli/console.h"
#include "cli/program.h"
#include "core/error.h"

namespace {

namespace console = twinray::console;

int fail(const std::string& name, const char* reason, int exit_code) {
  console::print_error("{}: {}\n", name, reason);
  return exit_code;
}

int run(const twinray::Invocation& invocation) {
  try {
    return twinray::run_program(invocation);
  } catch (const twinray::UsageError& error) {
    return fail(invocation.name, error.what(), 2);
  } catch (const std::bad_alloc&) {
    return fail(invocation.name, "out of memory", 1);
  } catch (const std::exception& error) {
    return fail(invocation.name, error.what(), 1);
  }
}

}  // namespace

int main(int argc, char** argv) {
  console::open();
  return console::finish(run(twinray::read_invocation({argv, std::size_t(argc)})));
}
