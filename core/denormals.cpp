// SPDX-License-Identifier: Apache-2.0
#include "core/denormals.h"

#if defined(__x86_64__)
#include <immintrin.h>
#elif defined(__aarch64__)
#include <cstdint>
#endif

namespace twinray {
namespace {

#if defined(__x86_64__)
constexpr unsigned flushes = denormal_flushes;
unsigned mode() { return _mm_getcsr(); }
void set_mode(unsigned mode) { _mm_setcsr(mode); }
bool are_fast() {
  __builtin_cpu_init();  // Needed in what runs before main().
  return __builtin_cpu_is("amd");
}
#elif defined(__aarch64__)
// Of FPCR: denormal results and operands become 0 (FZ, bit 24), or operands alone (FIZ, bit 0; Armv8.7).
constexpr unsigned flushes = 1u << 24 | 1u;
unsigned mode() {
  std::uint64_t mode;
  asm volatile("mrs %0, fpcr" : "=r"(mode));
  return unsigned(mode);
}
void set_mode(unsigned mode) { asm volatile("msr fpcr, %0" : : "r"(std::uint64_t(mode))); }
bool are_fast() { return true; }
#else
constexpr unsigned flushes = 0;
unsigned mode() { return 0; }
void set_mode(unsigned) {}
bool are_fast() { return true; }
#endif

}  // namespace

const bool denormals_are_fast = are_fast();

KeepDenormals::KeepDenormals() : saved_(mode()) { set_mode(saved_ & ~flushes); }
KeepDenormals::~KeepDenormals() { set_mode((mode() & ~flushes) | (saved_ & flushes)); }

}  // namespace twinray
