// SPDX-License-Identifier: Apache-2.0
#include "bench/machine.h"

#include <dlfcn.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <iterator>

#include "core/parallel.h"

namespace twinray::bench {
namespace {

std::string first_line(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  return std::getline(file, line) && !line.empty() ? line : "unknown";
}

/// The value of the first line "name : value".
std::string value_in(const std::string& path, const std::string& name) {
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);)
    if (line.starts_with(name))
      if (const auto colon = line.find(": "); colon != std::string::npos) return line.substr(colon + 2);
  return "unknown";
}

std::string governor() { return first_line("/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor"); }

/// Whether the Embree in this process can stop at an assertion: only then it asks for the function that says
/// so.
std::string embree_assertions() {
  Dl_info library;
  void* const symbol = dlsym(RTLD_DEFAULT, "rtcNewDevice");
  if (!symbol || !dladdr(symbol, &library) || !library.dli_fname) return "unknown";
  std::ifstream file(library.dli_fname, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  if (bytes.empty()) return "unknown";
  return bytes.find("__assert_fail") != std::string::npos ? "compiled in" : "not compiled in";
}

std::string memory() {
  const double bytes = double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGESIZE));
  return fmt::format("{:.1f} GB", 1e-9 * bytes);
}

std::string system_name() {
  utsname names;
  if (uname(&names) != 0) return "unknown";
  return fmt::format("{} {} {}", names.sysname, names.release, names.machine);
}

}  // namespace

std::vector<std::pair<std::string, std::string>> describe_machine() {
  std::vector<std::pair<std::string, std::string>> all{
      {"date", fmt::format("{:%Y-%m-%d %H:%M} UTC", fmt::gmtime(std::time(nullptr)))},
      {"program", "twinray " TWINRAY_VERSION},
      {"processor", value_in("/proc/cpuinfo", "model name")},
      {"threads", fmt::format("{}", available_threads())},
      {"memory", memory()},
      {"governor", governor()},
      {"load", first_line("/proc/loadavg")},
      {"system", system_name()},
      {"compiler", __VERSION__},
      {"flags", TWINRAY_FLAGS},
      {"libraries", TWINRAY_LIBRARIES}};
#ifdef TWINRAY_WITH_EMBREE
  all.push_back({"Embree's assertions", embree_assertions()});
#endif
  return all;
}

}  // namespace twinray::bench
