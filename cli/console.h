// SPDX-License-Identifier: Apache-2.0
// The program's words to people, on standard output and standard error: all pass here. A word that cannot be
// written never ends the program, for a picture is worth more; it is remembered and makes the exit code 1.
#pragma once
#include <fmt/format.h>

#include <string_view>
#include <utility>

namespace twinray::console {

/// First in main. A standard descriptor that is closed is taken, so that no file of ours becomes standard
/// output or error by chance; a pipe whose reader has gone, and a
/// file beyond the limit of sizes, are errors of writing, not signals.
void open();

/// Messages begin with this name from now on, in place of "twinray"; it must stay as long as the process.
void speak_as(const char* name) noexcept;
/// Who speaks in messages; from a signal handler, too.
std::string_view speaker() noexcept;

/// From now on standard output belongs to data: what print() prints goes to standard error.
void keep_output_for_data() noexcept;

/// Writes to standard output, at once.
void write(std::string_view text) noexcept;
/// Writes to standard error, at once.
void write_error(std::string_view text) noexcept;

/// write() of a text that is formatted by fmt.
template <typename... Values>
void print(fmt::format_string<Values...> format, Values&&... values) {
  write(fmt::format(format, std::forward<Values>(values)...));
}
/// write_error() of a text that is formatted by fmt.
template <typename... Values>
void print_error(fmt::format_string<Values...> format, Values&&... values) {
  write_error(fmt::format(format, std::forward<Values>(values)...));
}
/// "warning: TEXT", a line on standard error; only once, however often a process that renders many pictures
/// says the same.
void warn(std::string_view text);

/// Last in main: the exit code of a program that would have ended with `code`. Where a word was lost it says
/// so as far as it can, and 0 becomes 1.
int finish(int code);

}  // namespace twinray::console
