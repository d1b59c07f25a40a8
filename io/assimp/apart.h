// SPDX-License-Identifier: Apache-2.0
// Work on what a stranger sent, in a process of its own: whatever it does there ends with that.
#pragma once
#include <cstdint>
#include <functional>
#include <string>

namespace twinray {

/// Waits for a child: its exit code, or 128 + N where signal N ended it.
int exit_code_of(int child);

/// What work gave that ran apart: the bytes, or what went wrong.
struct ApartResult {
  std::string bytes;
  std::string fault;  ///< Empty: nothing.
};

/// Runs work that returns bytes, or throws Error, in a child of this process that may take so many bytes of
/// memory, and waits for it. A child that ends by a signal is a fault. Where no process can be made, as in a
/// sandbox, it runs here.
ApartResult run_apart(std::uint64_t most_bytes, const std::function<std::string()>& work);

}  // namespace twinray
