// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace twinray {

/// Whether the calling thread computes with denormal numbers: neither FTZ nor DAZ is set (on AArch64: FZ or
/// FIZ). It computes one and compares it with zero, which takes a fraction of a nanosecond; to read the mode
/// itself takes five. Where KeepDenormals can do nothing the answer is true.
inline bool keeps_denormals() {
#if defined(__x86_64__) || defined(__aarch64__)
  static constexpr float normal[2] = {0x1.8p-126f, 0x1p-126f};
  const volatile float* const operands = normal;
  float denormal = operands[0] - operands[1];
  // May be any number: so no flag of a user's compiler can reason about it.
#if defined(__x86_64__)
  asm("" : "+x"(denormal));
#else
  asm("" : "+w"(denormal));
#endif
  return denormal > 0;
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
