// SPDX-License-Identifier: Apache-2.0
// What a file that is compiled once for each instruction set has for those of this machine. To be
// included after Highway, under HWY_ONCE.
#pragma once
#include <cstdint>

#include "core/instruction_sets.h"

// What is compiled for a set where the file is, and nothing elsewhere.
#if HWY_TARGETS & HWY_AVX3
#define TWINRAY_IF_AVX3(statement) statement
#else
#define TWINRAY_IF_AVX3(statement)
#endif
#if HWY_TARGETS & HWY_AVX2
#define TWINRAY_IF_AVX2(statement) statement
#else
#define TWINRAY_IF_AVX2(statement)
#endif
#if HWY_TARGETS & HWY_SSE4
#define TWINRAY_IF_SSE4(statement) statement
#else
#define TWINRAY_IF_SSE4(statement)
#endif
#if HWY_TARGETS & HWY_NEON
#define TWINRAY_IF_NEON(statement) statement
#else
#define TWINRAY_IF_NEON(statement)
#endif

/// Appends what `call` gives in the namespace of each instruction set that this machine has, the fastest
/// first.
#define TWINRAY_APPEND_SUPPORTED(list, call)                                  \
  do {                                                                        \
    [[maybe_unused]] const std::int64_t supported = supported_targets();      \
    TWINRAY_IF_AVX3(if (supported & HWY_AVX3)(list).push_back(N_AVX3::call);) \
    TWINRAY_IF_AVX2(if (supported & HWY_AVX2)(list).push_back(N_AVX2::call);) \
    TWINRAY_IF_SSE4(if (supported & HWY_SSE4)(list).push_back(N_SSE4::call);) \
    TWINRAY_IF_NEON(if (supported & HWY_NEON)(list).push_back(N_NEON::call);) \
  } while (false)
