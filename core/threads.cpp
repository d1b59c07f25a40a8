// SPDX-License-Identifier: Apache-2.0
#include "core/threads.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace twinray {
namespace {

/// How many threads could be made, beside the calling one, that lived at the same time; up to `most`.
int try_threads(int most) {
  std::mutex gate;
  std::vector<std::thread> threads;
  threads.reserve(std::size_t(most));
  {
    const std::lock_guard closed(gate);
    try {
      while (int(threads.size()) < most) threads.emplace_back([&gate] { const std::lock_guard pass(gate); });
    } catch (const std::system_error&) {  // There are no more.
    }
  }
  for (std::thread& thread : threads) thread.join();
  return int(threads.size());
}

/// The kernel takes a thread that has ended out of its count a little later.
void let_threads_end() { std::this_thread::sleep_for(std::chrono::milliseconds(50)); }

}  // namespace

ThreadCount count_threads(int wanted) {
  static std::mutex mutex;
  static int tried = 1, usable = 1;  // Of a process, as its limits are: asked once.
  if (wanted <= 0) wanted = machine_threads();
  const std::lock_guard lock(mutex);
  if (wanted > tried) {
    usable = std::max(usable, 1 + try_threads(wanted - 1));
    tried = wanted;
    if (usable < wanted) let_threads_end();
  }
  return {wanted, std::min(wanted, usable)};
}

}  // namespace twinray
