// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <functional>

namespace twinray {

/// Runs body(begin, end) over parts of [0, count), of about `grain` items each, on up to `threads` threads
/// (0: as many as the process may use). Returns when all are done; an exception of a part is rethrown here,
/// once. On every thread denormal numbers are kept (FTZ and DAZ off) while a part runs, whatever the caller's
/// setting.
void parallel_for(std::size_t count, std::size_t grain, int threads,
                  const std::function<void(std::size_t begin, std::size_t end)>& body);

/// Runs both, possibly at the same time; for recursion.
void parallel_invoke(const std::function<void()>& a, const std::function<void()>& b);

/// Runs `body` so that the parallel work it starts uses up to `threads` threads (0: as many as the process
/// may use).
void with_threads(int threads, const std::function<void()>& body);

/// How many threads 0 stands for.
int available_threads();

/// While it lives, the calling thread computes with denormal numbers: clears FTZ and DAZ, and restores them.
class KeepDenormals {
 public:
  KeepDenormals();
  ~KeepDenormals();
  KeepDenormals(const KeepDenormals&) = delete;
  KeepDenormals& operator=(const KeepDenormals&) = delete;

 private:
  unsigned saved_;
};

}  // namespace twinray
