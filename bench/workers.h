// SPDX-License-Identifier: Apache-2.0
// Processes that work at the same time.
#pragma once
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <sys/types.h>

namespace twinray::bench {

/// In a worker: says "ready", then for each line on standard input does the work and prints the number that
/// it returns; until the input ends.
void answer_lines(const std::function<double()>& work);

/// Some workers, each a process of its own; they end with this object.
class WorkerCrew {
 public:
  /// Starts `command` (the program and its first arguments) with two arguments more, so many times, and waits
  /// until all are ready. Throws Error where one cannot start or ends.
  WorkerCrew(const std::vector<std::string>& command, const std::string& first, const std::string& second,
             int count);
  ~WorkerCrew();
  WorkerCrew(const WorkerCrew&) = delete;
  WorkerCrew& operator=(const WorkerCrew&) = delete;

  /// Lets the first `count` of them work once, at the same time; what each answers.
  std::vector<double> work(int count);

 private:
  struct Worker;
  std::vector<std::unique_ptr<Worker>> workers_;
};

}  // namespace twinray::bench
