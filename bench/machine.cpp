// SPDX-License-Identifier: Apache-2.0
#include "bench/machine.h"

#include <dlfcn.h>

#include <fstream>
#include <iterator>

#include "io/machine.h"

namespace twinray::bench {
namespace {

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

}  // namespace

std::vector<std::pair<std::string, std::string>> describe_machine() {
  std::vector<std::pair<std::string, std::string>> all = twinray::describe_machine();
  all.insert(all.end(), {{"program", "twinray " TWINRAY_VERSION},
                         {"compiler", __VERSION__},
                         {"flags", TWINRAY_FLAGS},
                         {"libraries", TWINRAY_LIBRARIES}});
#ifdef TWINRAY_WITH_EMBREE
  all.push_back({"Embree's assertions", embree_assertions()});
#endif
  return all;
}

}  // namespace twinray::bench
