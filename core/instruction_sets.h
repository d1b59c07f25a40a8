// SPDX-License-Identifier: Apache-2.0
// The instruction sets that kernels are compiled for, and the choice of one. To be included before
// Highway, which it tells for which of its targets.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

/// SSSE3 is no faster than the scalar kernels, AVX3_DL no faster than AVX3. Vectors of the last ones have no
/// size that a compiler knows: they cannot be members.
#define HWY_DISABLED_TARGETS \
  (HWY_SSSE3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)

namespace twinray {

/// The name of a Highway target for users: "avx512", "avx2", "sse4", "neon".
std::string simd_name(const char* target);

/// The bits of those Highway targets that are compiled for here and that this machine has. They are what
/// hwy::SupportedTargets() says; but Highway's library measures a clock when it is loaded, which takes 3 ms,
/// so on x86 it is not.
std::int64_t supported_targets() noexcept;

/// The names that BuildOptions::simd may have on this machine: "best", then from the fastest on "avx512",
/// "avx2", "sse4" and "neon" where it has them, and "scalar".
std::vector<std::string> available_instruction_sets();

/// Throws Error that lists the valid names of this machine.
[[noreturn]] void throw_no_such_set(const std::string& simd);

/// The kernel of options.simd among those of this machine, of which the fastest comes first; each has the
/// user's name of its instruction set. Throws Error that lists the valid names.
template <typename Kernel>
const Kernel& chosen(const std::vector<Kernel>& kernels, const std::string& simd) {
  for (const Kernel& kernel : kernels)
    if (simd == "best" || simd == kernel.name) return kernel;
  throw_no_such_set(simd);
}

}  // namespace twinray
