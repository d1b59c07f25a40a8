// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "accel/engines.h"

namespace twinray {

/// An engine, and why that one.
struct EngineChoice {
  Engine engine;
  std::string reason;  ///< A clause: "the fastest on every scene measured, ...".
};

/// The fastest canonical engine for a geometry with the instruction set of options.simd, by what the
/// benchmarks measured (docs/performance.md); it has the options given. All canonical engines give the same
/// bits, so the choice changes no answer.
EngineChoice fastest_engine(const Geometry& geometry, const BuildOptions& options = {});

}  // namespace twinray
