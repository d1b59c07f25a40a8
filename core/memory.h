// SPDX-License-Identifier: Apache-2.0
// Whether there is memory for what is about to be made: asked before the work, because a system that promises
// more than it has ends the process later, without a word.
#pragma once
#include <cstdint>
#include <span>
#include <string>

namespace twinray {

/// Memory that a process may still take.
struct MemoryLimit {
  std::uint64_t bytes = UINT64_MAX;
  std::string name;  ///< What sets the limit: "the machine", ...
};

/// Something that is about to be made.
struct MemoryNeed {
  std::string name;
  std::uint64_t bytes = 0;
  std::string instead;  ///< How to need less, and how much: "24.0 MB with --memory-mode=compact"; or empty.
};

/// The tightest of: the machine's available memory and free swap; what the process's control group and those
/// above it (version 1 or 2) have left, where memory that holds files counts as left; what is left of the
/// address space (ulimit -v), and of its data (ulimit -d). Limits that cannot be read are none. `root` is the
/// folder that holds proc and sys.
MemoryLimit available_memory(const std::string& root = "/");

/// Throws Error, which says how much is needed for what, and what would need less, where the needs exceed the
/// limit.
void check_memory(std::span<const MemoryNeed> needs, const MemoryLimit& limit = available_memory());

/// "512 bytes", "1.5 MB", "64.0 GB": powers of 1000.
std::string bytes_text(std::uint64_t bytes);

}  // namespace twinray
