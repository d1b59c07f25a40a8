// SPDX-License-Identifier: Apache-2.0
#include "cli/version.h"

#include <fmt/format.h>

#include <string_view>

#include "accel/accelerator.h"
#include "core/instruction_sets.h"

namespace twinray {
namespace {

std::string instruction_sets() {
#if defined(__x86_64__)
  std::string names = "x86-64";
  __builtin_cpu_init();
  if (__builtin_cpu_supports("sse4.2")) names += " sse4.2";
  if (__builtin_cpu_supports("avx")) names += " avx";
  if (__builtin_cpu_supports("avx2")) names += " avx2";
  if (__builtin_cpu_supports("fma")) names += " fma";
  if (__builtin_cpu_supports("avx512f")) names += " avx512f";
  return names;
#else
#if defined(__aarch64__)
  std::string names = "aarch64";
#else
  std::string names = "neither x86-64 nor aarch64";
#endif
  for (const std::string& set : available_instruction_sets())
    if (set != "best" && set != "scalar") names.append(" ").append(set);
  return names;
#endif
}

}  // namespace

std::string version_name() { return "twinray " TWINRAY_VERSION; }

std::string version_text() {
  std::string engines;
  for (const Backend backend : available_backends()) engines.append(" ").append(backend_name(backend));
  return fmt::format(
      "{}\nengines:         {}\nlibraries:        {}\ncompiler:         {}\nmachine:          {}\n",
      version_name(), engines, TWINRAY_LIBRARIES, __VERSION__, instruction_sets());
}

}  // namespace twinray
