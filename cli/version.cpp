// SPDX-License-Identifier: Apache-2.0
#include "cli/version.h"

#include <fmt/format.h>

#include <string_view>

#include "accel/accelerator.h"

namespace twinray {
namespace {

std::string instruction_sets() {
  std::string names = "x86-64";
#if defined(__x86_64__)
  __builtin_cpu_init();
  if (__builtin_cpu_supports("sse4.2")) names += " sse4.2";
  if (__builtin_cpu_supports("avx")) names += " avx";
  if (__builtin_cpu_supports("avx2")) names += " avx2";
  if (__builtin_cpu_supports("fma")) names += " fma";
  if (__builtin_cpu_supports("avx512f")) names += " avx512f";
#else
  names = "other than x86-64";
#endif
  return names;
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
