// SPDX-License-Identifier: Apache-2.0
// Google Benchmark as a stopwatch: bodies that take turns, round after round.
#pragma once
#include <functional>
#include <string>
#include <vector>

namespace twinray::bench {

/// Something to time. The body runs once an iteration.
struct Timed {
  std::string name;
  std::function<void()> body;
};

/// What one iteration took.
struct Seconds {
  double cpu = 0;  ///< Of the calling thread, or of the whole process.
  double wall = 0;
};

enum class Clock {
  thread,   ///< CPU time of the calling thread: for bodies that start no other.
  process,  ///< CPU time of all threads.
};

struct Rounds {
  int count = 7;  ///< >= 1.
  /// A body that takes less is repeated within a round, until about so many seconds have passed; 0: each runs
  /// once, and nothing warms up.
  double least_seconds = 0.03;
  Clock clock = Clock::thread;
};

/// Each round runs all bodies once, one after the other, and starts with another one than the round before;
/// so whatever slows the machine down for a while hits all of them alike. One round more, not recorded, warms
/// up and finds how often each body must be repeated. results[i][round] is that of timed[i].
std::vector<std::vector<Seconds>> run_rounds(const std::vector<Timed>& timed, const Rounds& rounds);

}  // namespace twinray::bench
