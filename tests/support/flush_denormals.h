// SPDX-License-Identifier: Apache-2.0
// A host program's thread that takes denormal numbers for 0.
#pragma once
#include <cstdint>

namespace twinray::test {

/// Switches denormal numbers off while it lives (FTZ and DAZ; on AArch64 FZ), as a program does that was
/// compiled with -ffast-math.
class FlushDenormals {
 public:
#if defined(__x86_64__)
  using Mode = unsigned;
  static constexpr Mode results = 0x8000, operands = 0x0040, flushes = results | operands;
#else
  using Mode = std::uint64_t;
  static constexpr Mode results = 1u << 24, operands = results, flushes = results;
#endif

  explicit FlushDenormals(Mode which = flushes) : saved_(mode()) { set_mode(saved_ | which); }
  ~FlushDenormals() { set_mode(saved_); }
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;
  static bool are_flushed() { return (mode() & flushes) == flushes; }

 private:
#if defined(__x86_64__)
  static Mode mode() { return __builtin_ia32_stmxcsr(); }
  static void set_mode(Mode mode) { __builtin_ia32_ldmxcsr(mode); }
#elif defined(__aarch64__)
  static Mode mode() {
    Mode mode;
    asm volatile("mrs %0, fpcr" : "=r"(mode));
    return mode;
  }
  static void set_mode(Mode mode) { asm volatile("msr fpcr, %0" : : "r"(mode)); }
#else
#error "no test knows how this processor switches denormal numbers off"
#endif

  Mode saved_;
};

}  // namespace twinray::test
