// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <functional>

namespace twinray {

/// Runs body(begin, end) over the parts [0, grain), [grain, 2 grain), ... of [0, count), on up to `threads`
/// threads (0: as many as the surroundings allow, see with_threads; may be more than the machine has). The
/// parts depend on nothing but count and grain (0 counts as 1), so what a body makes of its part alone does
/// not depend on the threads. Returns when all have run; if some throw, the exception of one is rethrown here
/// and parts that have not begun are left out. On every thread denormal numbers are kept (FTZ and DAZ off)
/// while a part runs, whatever the caller's setting.
void parallel_for(std::size_t count, std::size_t grain, int threads,
                  const std::function<void(std::size_t begin, std::size_t end)>& body);

/// Runs both, possibly at the same time; for recursion. Exceptions and denormal numbers as above.
void parallel_invoke(const std::function<void()>& a, const std::function<void()>& b);

/// Runs `body` on the calling thread so that the parallel work it starts uses up to `threads` threads, this
/// one among them (0: as many as the surroundings allow; outermost, as many as the process may use). Denormal
/// numbers as above.
void with_threads(int threads, const std::function<void()>& body);

/// A number >= 0 by which threads that work at the same time in one place mostly differ.
int thread_index();

/// How many threads the process may use: what 0 stands for outermost.
int available_threads();

}  // namespace twinray
