// SPDX-License-Identifier: Apache-2.0
#include "io/assimp/apart.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <exception>

namespace twinray {
namespace {

constexpr char good = '+', bad = '-';

/// What sanitizers map for themselves would count as data.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool bounds_memory = false;
#else
constexpr bool bounds_memory = true;
#endif

/// What is sent: whether it went well, and the bytes or the fault.
std::string message_of(const std::function<std::string()>& work) {
  try {
    return good + work();
  } catch (const std::bad_alloc&) {
    return std::string(1, bad) + "it would take more memory than its size allows";
  } catch (const std::exception& error) {
    return bad + std::string(error.what());
  }
}

ApartResult result_of(std::string message) {
  ApartResult result;
  const bool is_good = message.front() == good;
  message.erase(0, 1);
  if (!is_good && message.empty()) message = "it cannot be read, and the library does not say why";
  (is_good ? result.bytes : result.fault) = std::move(message);
  return result;
}

/// Signals mean to a child what they mean to any process, and nobody hears what a library says at its end.
void forget_the_parent(std::uint64_t most_bytes) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (int number = 1; number < NSIG; ++number) std::signal(number, SIG_DFL);
  if (const int nowhere = open("/dev/null", O_WRONLY); nowhere >= 0) dup2(nowhere, STDERR_FILENO);
  rlimit memory{};
  getrlimit(RLIMIT_DATA, &memory);
  memory.rlim_cur = std::min<rlim_t>(memory.rlim_cur, most_bytes);
  if (bounds_memory) setrlimit(RLIMIT_DATA, &memory);
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
}

void send(int to, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(to, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR) return;
    if (written > 0) bytes.remove_prefix(std::size_t(written));
  }
}

std::string receive(int from) {
  std::string bytes;
  std::array<char, 65536> block;
  for (ssize_t count = 1; count != 0;) {
    count = read(from, block.data(), block.size());
    if (count < 0 && errno != EINTR) break;
    if (count > 0) bytes.append(block.data(), std::size_t(count));
  }
  return bytes;
}

}  // namespace

int exit_code_of(int child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

ApartResult run_apart(std::uint64_t most_bytes, const std::function<std::string()>& work) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) return result_of(message_of(work));
  const pid_t child = fork();
  if (child == 0) {
    forget_the_parent(most_bytes);
    send(ends[1], message_of(work));
    _exit(0);
  }
  close(ends[1]);
  std::string message = child > 0 ? receive(ends[0]) : "";
  close(ends[0]);
  if (child < 0) return result_of(message_of(work));
  const int code = exit_code_of(child);
  if (code > 128) return {"", fmt::format("what reads it was ended by signal {}", code - 128)};
  if (message.empty()) return {"", "what reads it ended without a word"};
  return result_of(std::move(message));
}

}  // namespace twinray
