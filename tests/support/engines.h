// SPDX-License-Identifier: Apache-2.0
// Renders that must have the same bits whichever engine, instruction set and number of threads makes them.
#pragma once
#include "integrators/integrator.h"

namespace twinray::test {

/// Checks that every engine renders what brute force does with one thread.
void check_engines(const Scene& scene, const Integrator& integrator);

/// Checks that waves render what the reference does, and trace as many rays, on every engine and instruction
/// set, by each way of finding direct light.
void check_waves(const Scene& scene);

}  // namespace twinray::test
