// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace twinray::test {

/// Whether a sanitizer is compiled in, whose own memory no bound of memory holds for.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool has_sanitizer = true;
#else
inline constexpr bool has_sanitizer = false;
#endif

/// Whether it is the thread sanitizer. It hands signals on when a call returns, so one that waits for ever is
/// not ended by them; and in a sandbox it cannot read the names by which races of libraries are passed over.
#ifdef __SANITIZE_THREAD__
inline constexpr bool has_thread_sanitizer = true;
#else
inline constexpr bool has_thread_sanitizer = false;
#endif

}  // namespace twinray::test
