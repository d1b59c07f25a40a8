// SPDX-License-Identifier: Apache-2.0
// The one table of engines: by these names the program, the checks and the benchmarks know them.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "accel/accelerator.h"

namespace twinray {

/// A backend with its options.
struct Engine {
  std::string name;
  Backend backend = Backend::bvh;
  BuildOptions build;
  std::string what;  ///< In a few words, for people.

  /// Whether it promises the same bits as all others that do.
  bool is_canonical() const {
    return backend != Backend::embree_native && build.triangle_test == TriangleTest::woop;
  }
};

/// The engines of this build to choose among, all options at their defaults: "bvh", "embree", "bvh-2" (the
/// binary tree), "embree-native" and "brute-force".
std::vector<Engine> engines();

/// Further engines of this build: other builders, splits, qualities and instruction sets, which benchmarks
/// measure and checks compare. Each has the name of the engine that it varies in front: "bvh-2-median".
std::vector<Engine> engine_variants();

/// The names of engines().
std::vector<std::string> engine_names();

/// The engine or variant of a name, if this build has it.
std::optional<Engine> find_engine(const std::string& name);

/// The engine of a name, with the other options as given; of a variant, whose options its name says, only the
/// number of threads is taken. Throws Error that lists engine_names().
Engine named_engine(const std::string& name, const BuildOptions& build = {});

}  // namespace twinray
