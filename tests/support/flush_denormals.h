// SPDX-License-Identifier: Apache-2.0
// A host program's thread that takes denormal numbers for 0.
#pragma once

namespace twinray::test {

#ifdef __SSE__
/// Switches denormal numbers off while it lives (FTZ and DAZ), as a program does that was compiled with
/// -ffast-math.
class FlushDenormals {
 public:
  FlushDenormals() : saved_(__builtin_ia32_stmxcsr()) { __builtin_ia32_ldmxcsr(saved_ | 0x8040u); }
  ~FlushDenormals() { __builtin_ia32_ldmxcsr(saved_); }
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;
  static bool are_flushed() { return (__builtin_ia32_stmxcsr() & 0x8040u) == 0x8040u; }

 private:
  unsigned saved_;
};
#endif

}  // namespace twinray::test
