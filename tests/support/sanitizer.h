// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdlib>

namespace twinray::test {

/// Whether a sanitizer is compiled in, whose own memory no bound of memory holds for.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool has_sanitizer = true;
#else
inline constexpr bool has_sanitizer = false;
#endif

/// Whether it is the thread sanitizer. It hands a signal on when the call returns that it came in; and in a
/// sandbox it cannot read the names by which races within libraries are passed over.
#ifdef __SANITIZE_THREAD__
inline constexpr bool has_thread_sanitizer = true;
#else
inline constexpr bool has_thread_sanitizer = false;
#endif

/// A sandbox keeps out the search for leaks, which a sanitizer makes from a process of its own: programs do
/// without it meanwhile.
struct NoLeakSearch {
  NoLeakSearch() { setenv("ASAN_OPTIONS", "detect_leaks=0", 1); }
  ~NoLeakSearch() { unsetenv("ASAN_OPTIONS"); }
  NoLeakSearch(const NoLeakSearch&) = delete;
  NoLeakSearch& operator=(const NoLeakSearch&) = delete;
};

}  // namespace twinray::test
