// SPDX-License-Identifier: Apache-2.0
#include "accel/instruction_sets.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "accel/accelerator.h"
#include "accel/wide/kernel.h"
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
  for (const WideKernel& kernel : wide_kernels(TriangleTest::woop)) names.push_back(kernel.name);
  return names;
}

}  // namespace twinray
