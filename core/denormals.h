// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace twinray {

/// Whether this processor computes a denormal number as fast as any other: AMD's and AArch64's do, Intel's
/// call microcode, which takes fifty nanoseconds.
extern const bool denormals_are_fast;

/// Whether the calling thread computes with denormal numbers, by computing one and comparing it with zero:
/// takes a fraction of a nanosecond where denormals_are_fast.
inline bool computes_denormals() {
  static constexpr float normal[2] = {0x1.8p-126f, 0x1p-126f};
  const volatile float* const operands = normal;
  float denormal = operands[0] - operands[1];
  // May be any number: so no flag of a user's compiler can reason about it.
#if defined(__x86_64__)
  asm("" : "+x"(denormal));
#elif defined(__aarch64__)
  asm("" : "+w"(denormal));
#endif
  return denormal > 0;
}

#if defined(__x86_64__)
/// Of MXCSR: results that are denormal become 0 (FTZ, 0x8000), and so do operands (DAZ, 0x0040).
inline constexpr unsigned denormal_flushes = 0x8000 | 0x0040;
#endif

/// The same by the thread's mode: five nanoseconds on AMD's processors, nothing that could be measured on
/// Intel's.
inline bool mode_keeps_denormals() {
#if defined(__x86_64__)
  return (__builtin_ia32_stmxcsr() & denormal_flushes) == 0;
#else
  return computes_denormals();
#endif
}

/// Whether the calling thread computes with denormal numbers: neither FTZ nor DAZ is set (on AArch64: FZ or
/// FIZ). Found the way that is the faster one on this processor; where KeepDenormals can do nothing the
/// answer is true.
inline bool keeps_denormals() {
#if defined(__x86_64__) || defined(__aarch64__)
  return denormals_are_fast ? computes_denormals() : mode_keeps_denormals();
#else
  return true;
#endif
}

/// While it lives, the calling thread computes with denormal numbers: clears what switches them off, and
/// restores it.
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
