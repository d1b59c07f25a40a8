// SPDX-License-Identifier: Apache-2.0
#include "core/parallel.h"

#include <algorithm>
#include <optional>

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/task_arena.h>

#include "core/denormals.h"
#include "core/fork_join.h"
#include "core/threads.h"

namespace twinray {
namespace {

/// Where the machine's threads cannot all be made, oneTBB is held to those that can, from its first use until
/// the process ends: it does not survive a thread that it has promised itself and does not get.
bool holds_to_usable_threads() {
  static const auto limit = [] {
    const ThreadCount machine = count_threads(0);
    std::optional<tbb::global_control> lower;
    if (machine.usable < machine.wanted)
      lower.emplace(tbb::global_control::max_allowed_parallelism, std::size_t(machine.usable));
    return lower;
  }();
  return limit.has_value();
}

/// In the surroundings for 0, else in an arena of that many threads; more than the process has are made.
template <class Body>
void run_with(int threads, const Body& body) {
  // The outermost surroundings are as wide as the machine, whatever can be made.
  const bool is_too_wide =
      holds_to_usable_threads() && tbb::this_task_arena::max_concurrency() > available_threads();
  if (threads <= 0 && !is_too_wide) return body();
  const int usable = count_threads(threads).usable;
  std::optional<tbb::global_control> more;
  if (usable > available_threads())
    more.emplace(tbb::global_control::max_allowed_parallelism, std::size_t(usable));
  tbb::task_arena arena(usable);
  arena.execute(body);
}

}  // namespace

void parallel_for(std::size_t count, std::size_t grain, int threads,
                  const std::function<void(std::size_t, std::size_t)>& body) {
  if (count == 0) return;
  const std::size_t size = std::max<std::size_t>(grain, 1);
  const std::size_t parts = (count - 1) / size + 1;
  ForkJoin work;
  const auto run_parts = [&](const tbb::blocked_range<std::size_t>& range) {
    const ForkJoin::Part ordered(work);
    const KeepDenormals keep;
    for (std::size_t part = range.begin(); part < range.end(); ++part)
      body(part * size, std::min(count - part * size, size) + part * size);
  };
  run_with(threads, [&] {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, parts), run_parts, tbb::simple_partitioner());
  });
}

void parallel_invoke(const std::function<void()>& a, const std::function<void()>& b) {
  ForkJoin work;
  const auto kept = [&](const std::function<void()>& body) {
    const ForkJoin::Part ordered(work);
    const KeepDenormals keep;
    body();
  };
  run_with(0, [&] { tbb::parallel_invoke([&] { kept(a); }, [&] { kept(b); }); });
}

void with_threads(int threads, const std::function<void()>& body) {
  ForkJoin work;
  run_with(threads, [&] {
    const ForkJoin::Part ordered(work);
    const KeepDenormals keep;
    body();
  });
}

int machine_threads() { return tbb::info::default_concurrency(); }

int thread_index() { return std::max(tbb::this_task_arena::current_thread_index(), 0); }

int available_threads() { return count_threads(0).usable; }

}  // namespace twinray
