// SPDX-License-Identifier: Apache-2.0
#include "cli/options/limits.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/time.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>

#include "core/error.h"

namespace twinray {
namespace {

void limit_memory(double megabytes) {
  rlimit limit{};
  getrlimit(RLIMIT_DATA, &limit);
  limit.rlim_cur = std::min(rlim_t(1e6 * megabytes), limit.rlim_max);
  if (setrlimit(RLIMIT_DATA, &limit) != 0) throw Error(fmt::format("--memory: {}", std::strerror(errno)));
}

void limit_time(double seconds) {
  const double whole = std::floor(seconds);
  const itimerval time{
      .it_interval = {},
      .it_value = {.tv_sec = time_t(whole),
                   .tv_usec = std::max(suseconds_t(1), suseconds_t(1e6 * (seconds - whole)))}};
  setitimer(ITIMER_REAL, &time, nullptr);
}

}  // namespace

void limit_process(const ProcessLimits& limits) {
  if (limits.seconds) limit_time(*limits.seconds);
  if (limits.megabytes) limit_memory(*limits.megabytes);
}

}  // namespace twinray
