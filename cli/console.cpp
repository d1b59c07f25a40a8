// SPDX-License-Identifier: Apache-2.0
#include "cli/console.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <functional>
#include <set>
#include <string>

namespace twinray::console {
namespace {

struct Stream {
  std::FILE* file;
  int error;  ///< The errno of the first failure, or 0.
};

// The two streams belong to the process; so does what failed on them.
Stream output{stdout, 0};
Stream errors{stderr, 0};
bool output_is_for_data = false;
std::atomic<const char*> speaker_name = "twinray";
static_assert(std::atomic<const char*>::is_always_lock_free);

void write_to(Stream& stream, std::string_view text) noexcept {
  errno = 0;
  const bool is_written =
      std::fwrite(text.data(), 1, text.size(), stream.file) == text.size() && std::fflush(stream.file) == 0;
  if (!is_written && stream.error == 0) stream.error = errno == 0 ? EIO : errno;
}

}  // namespace

void open() {
  // Opened the wrong way round: reading and writing fail as they would on a closed descriptor.
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(descriptor, F_GETFD) == -1)
      static_cast<void>(::open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY));
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

void speak_as(const char* name) noexcept { speaker_name = name; }

std::string_view speaker() noexcept { return speaker_name.load(); }

void keep_output_for_data() noexcept { output_is_for_data = true; }

void write(std::string_view text) noexcept { write_to(output_is_for_data ? errors : output, text); }

void write_error(std::string_view text) noexcept { write_to(errors, text); }

void warn(std::string_view text) {
  static std::set<std::string, std::less<>> warnings;
  if (warnings.insert(std::string(text)).second) print_error("warning: {}\n", text);
}

int finish(int code) {
  if (output.error != 0)
    print_error("{}: standard output cannot be written: {}\n", speaker(), std::strerror(output.error));
  return code == 0 && (output.error != 0 || errors.error != 0) ? 1 : code;
}

}  // namespace twinray::console
