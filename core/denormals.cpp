// SPDX-License-Identifier: Apache-2.0
#include "core/denormals.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace twinray {

#if defined(__x86_64__)
// Bits of MXCSR: results that are denormal become 0 (FTZ, 0x8000), and so do operands (DAZ, 0x0040).
KeepDenormals::KeepDenormals() : saved_(_mm_getcsr()) { _mm_setcsr(saved_ & ~0x8040u); }
KeepDenormals::~KeepDenormals() { _mm_setcsr((_mm_getcsr() & ~0x8040u) | (saved_ & 0x8040u)); }
#else
KeepDenormals::KeepDenormals() : saved_(0) {}
KeepDenormals::~KeepDenormals() = default;
#endif

}  // namespace twinray
