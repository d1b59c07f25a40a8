// SPDX-License-Identifier: Apache-2.0
// The program: exceptions become messages and exit codes here, and nowhere else.
#include <unistd.h>

#include <cstdlib>
#include <exception>
#include <new>
#include <string>
#include <string_view>

#include "cli/console.h"
#include "cli/program.h"
#include "core/error.h"

namespace {

namespace console = twinray::console;

int fail(const char* reason, int exit_code) {
  console::print_error("{}: {}\n", console::speaker(), reason);
  return exit_code;
}

int run(const twinray::Invocation& invocation) {
  try {
    return twinray::run_program(invocation);
  } catch (const twinray::UsageError& error) {
    return fail(error.what(), 2);
  } catch (const std::bad_alloc&) {
    return fail("out of memory", 1);
  } catch (const std::exception& error) {
    return fail(error.what(), 1);
  }
}

/// Memory can end where no exception may leave: in a function that promises to throw none, or in a thread of
/// a library.
[[noreturn]] void end_without_memory() {
  try {
    if (const std::exception_ptr thrown = std::current_exception()) std::rethrow_exception(thrown);
  } catch (const std::bad_alloc&) {
    for (const std::string_view part : {console::speaker(), std::string_view(": out of memory\n")})
      [[maybe_unused]] const auto written = ::write(STDERR_FILENO, part.data(), part.size());
    std::_Exit(1);
  } catch (...) {
  }
  std::abort();
}

}  // namespace

int main(int argc, char** argv) {
  std::set_terminate(end_without_memory);
  console::open();
  const twinray::Invocation invocation = twinray::read_invocation({argv, std::size_t(argc)});
  console::speak_as(invocation.name.c_str());
  return console::finish(run(invocation));
}
