// SPDX-License-Identifier: Apache-2.0
#include "cli/sandbox/child.h"

#include <fmt/format.h>
#include <sys/prctl.h>

#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>

#include "core/error.h"
#include "io/assimp/apart.h"

namespace twinray {

std::optional<int> go_on_in_child() {
  const pid_t child = fork();
  if (child < 0) throw Error(fmt::format("no process can be begun to work in: {}", std::strerror(errno)));
  if (child == 0) {
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    return std::nullopt;
  }
  return exit_code_of(child);
}

}  // namespace twinray
