// SPDX-License-Identifier: Apache-2.0
#include "core/instruction_sets.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <hwy/targets.h>

#include <utility>

#include "core/error.h"

#if HWY_ARCH_X86
#include <cpuid.h>
#endif

namespace twinray {
namespace {

#if HWY_ARCH_X86
/// Of the instructions that Highway uses besides AVX2, those that __builtin_cpu_supports() does not know in
/// every compiler: conversions to and from 16-bit numbers, and leading zeros.
bool has_f16c_and_lzcnt() noexcept {
  unsigned a = 0, b = 0, basic = 0, extended = 0, d = 0;
  return __get_cpuid(1, &a, &b, &basic, &d) && (basic & bit_F16C) &&
         __get_cpuid(0x80000001, &a, &b, &extended, &d) && (extended & bit_LZCNT);
}

/// Whether the processor has them, and the system keeps their registers.
#define TWINRAY_HAS(instructions) (__builtin_cpu_supports(instructions) != 0)

bool has_sse4() noexcept {
  return TWINRAY_HAS("ssse3") && TWINRAY_HAS("sse4.1") && TWINRAY_HAS("sse4.2") && TWINRAY_HAS("pclmul") &&
         TWINRAY_HAS("aes");
}
bool has_avx2() noexcept {
  return has_sse4() && TWINRAY_HAS("avx2") && TWINRAY_HAS("fma") && TWINRAY_HAS("bmi") &&
         TWINRAY_HAS("bmi2") && has_f16c_and_lzcnt();
}
bool has_avx3() noexcept {
  return has_avx2() && TWINRAY_HAS("avx512f") && TWINRAY_HAS("avx512vl") && TWINRAY_HAS("avx512dq") &&
         TWINRAY_HAS("avx512bw");
}
#undef TWINRAY_HAS

std::int64_t find_targets() noexcept {
  __builtin_cpu_init();
  return (has_sse4() ? HWY_SSE4 : 0) | (has_avx2() ? HWY_AVX2 : 0) | (has_avx3() ? HWY_AVX3 : 0);
}
#else
std::int64_t find_targets() noexcept { return hwy::SupportedTargets(); }
#endif

}  // namespace

std::int64_t supported_targets() noexcept {
  static const std::int64_t targets = find_targets() & HWY_TARGETS;
  return targets;
}

std::string simd_name(const char* target) {
  std::string name = target;
  if (name == "AVX3") return "avx512";
  for (char& c : name)
    if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  return name;
}

void throw_no_such_set(const std::string& simd) {
  throw Error(fmt::format("there is no instruction set \"{}\" on this machine; valid are {}", simd,
                          fmt::join(available_instruction_sets(), ", ")));
}

std::vector<std::string> available_instruction_sets() {
  std::vector<std::string> names{"best"};
  for (const auto& [target, name] :
       {std::pair{HWY_AVX3, "AVX3"}, {HWY_AVX2, "AVX2"}, {HWY_SSE4, "SSE4"}, {HWY_NEON, "NEON"}})
    if (supported_targets() & target) names.push_back(simd_name(name));
  names.emplace_back("scalar");
  return names;
}

}  // namespace twinray
