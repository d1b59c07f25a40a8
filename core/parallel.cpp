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
#if defined(__x86_64__)
#include <immintrin.h>
#endif

#include "core/fork_join.h"

namespace twinray {
namespace {

/// In the surroundings for 0, else in an arena of that many threads; more than the process has are made.
template <class Body>
void run_with(int threads, const Body& body) {
  if (threads <= 0) return body();
  std::optional<tbb::global_control> more;
  if (threads > available_threads())
    more.emplace(tbb::global_control::max_allowed_parallelism, std::size_t(threads));
  tbb::task_arena arena(threads);
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
  tbb::parallel_invoke([&] { kept(a); }, [&] { kept(b); });
}

void with_threads(int threads, const std::function<void()>& body) {
  ForkJoin work;
  run_with(threads, [&] {
    const ForkJoin::Part ordered(work);
    const KeepDenormals keep;
    body();
  });
}

int available_threads() { return tbb::info::default_concurrency(); }

#if defined(__x86_64__)
// Bits of MXCSR: results that are denormal become 0 (FTZ, 0x8000), and so do operands (DAZ, 0x0040).
KeepDenormals::KeepDenormals() : saved_(_mm_getcsr()) { _mm_setcsr(saved_ & ~0x8040u); }
KeepDenormals::~KeepDenormals() { _mm_setcsr((_mm_getcsr() & ~0x8040u) | (saved_ & 0x8040u)); }
#else
KeepDenormals::KeepDenormals() : saved_(0) {}
KeepDenormals::~KeepDenormals() = default;
#endif

}  // namespace twinray
