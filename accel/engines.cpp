// SPDX-License-Identifier: Apache-2.0
#include "accel/engines.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.h"

namespace twinray {
namespace {

constexpr const char* binary_bvh = "bvh-2";

}  // namespace

std::vector<std::string> engine_names() {
  std::vector<std::string> names;
  for (const Backend backend : available_backends()) {
    names.push_back(backend_name(backend));
    if (backend == Backend::bvh) names.emplace_back(binary_bvh);
  }
  return names;
}

Engine named_engine(const std::string& name, const BuildOptions& build) {
  Engine engine{.name = name, .build = build};
  if (name == binary_bvh) {
    engine.build.bvh_width = 2;
    return engine;
  }
  for (const Backend backend : available_backends())
    if (name == backend_name(backend)) {
      engine.backend = backend;
      return engine;
    }
  throw Error(fmt::format("there is no engine \"{}\" in this build; valid are {}", name,
                          fmt::join(engine_names(), ", ")));
}

}  // namespace twinray
