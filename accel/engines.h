// SPDX-License-Identifier: Apache-2.0
// Engines by the names that a crosscheck knows them by.
#pragma once
#include <string>
#include <vector>

#include "accel/accelerator.h"

namespace twinray {

/// A backend with its options.
struct Engine {
  std::string name;
  Backend backend = Backend::bvh;
  BuildOptions build;

  /// Whether it promises the same bits as all others that do.
  bool is_canonical() const {
    return backend != Backend::embree_native && build.triangle_test == TriangleTest::woop;
  }
};

/// The names of this build's engines: those of its backends, and "bvh-2", the binary tree.
std::vector<std::string> engine_names();

/// The engine of a name, with the other options as given. Throws Error that lists the names of this build.
Engine named_engine(const std::string& name, const BuildOptions& build = {});

}  // namespace twinray
