// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace twinray {

/// How many threads the process may run on at once: cores that it is not kept from.
int machine_threads();

/// Threads that were asked for, and those of them that the process can have, the calling one among both.
struct ThreadCount {
  int wanted = 1, usable = 1;
};

/// How many threads the system lets the process run at the same time: where a limit is reached (ulimit -u,
/// that of a container), fewer than `wanted` (0: machine_threads()). Found by making
/// that many, the first time that so many are asked for.
ThreadCount count_threads(int wanted);

}  // namespace twinray
