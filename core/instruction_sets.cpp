// SPDX-License-Identifier: Apache-2.0
#include "core/instruction_sets.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <hwy/targets.h>

#include <cstdint>
#include <utility>

#include "core/error.h"

namespace twinray {

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
  const std::int64_t usable = std::int64_t(hwy::SupportedTargets()) & HWY_TARGETS;
  for (const auto& [target, name] :
       {std::pair{HWY_AVX3, "AVX3"}, {HWY_AVX2, "AVX2"}, {HWY_SSE4, "SSE4"}, {HWY_NEON, "NEON"}})
    if (usable & target) names.push_back(simd_name(name));
  names.emplace_back("scalar");
  return names;
}

}  // namespace twinray
