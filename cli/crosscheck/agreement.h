// SPDX-License-Identifier: Apache-2.0
// One scene, rendered by every engine, integrator, sampler and number of threads: all pictures must have the
// same bits.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "accel/engines.h"
#include "core/scene.h"

namespace twinray {

/// An engine to compare.
struct AgreementEngine : Engine {
  std::vector<int> threads{1, 2, 7};  ///< It renders everything on each of these numbers of threads.
};

/// All engines of this build that promise the same bits: the hand-written BVH with each split method and
/// builder, the wide one, embree, and brute force, which comes last.
std::vector<AgreementEngine> canonical_engines();

/// The same, and the wide BVH and embree with each other instruction set of this machine, on two threads
/// only. The first is what all are compared with.
std::vector<AgreementEngine> agreement_engines();

/// The BVH with Moeller and Trumbore's test, which does not make the promise: a comparison that is worth
/// anything finds that it differs on most scenes.
AgreementEngine differing_engine();

struct AgreementOptions {
  int width = 48, height = 36;  ///< Pixels, 1 to 65536 each; nine tiles, so that seven threads have work.
  std::uint32_t samples = 2;    ///< Per pixel.
  std::uint64_t seed = 0;
  std::vector<AgreementEngine> engines = agreement_engines();  ///< At least one.
  /// Primitive tests that brute force may make, roughly: some ten seconds.
  double brute_force_tests = 1e9;
};

/// What the comparison of one scene found.
struct SceneAgreement {
  std::size_t renders = 0;
  std::uint64_t pixels = 0, rays = 0;  ///< Of all renders together.
  int brute_force_pixels = 0;          ///< Of each of brute force's renders: the whole frame, or its middle.
  std::vector<std::string> differences;  ///< One for each render that differs from the first of its kind.
};

/// Renders normals, ambient occlusion, a furnace, direct light by lights and by hemisphere, and paths, each
/// with both samplers: by each engine, with 1, 2 and 7 threads. Every film is compared with the first
/// engine's on one thread, and so are rays by kind. Where brute force would need more tests than the options
/// allow, it renders the middle of the frame alone. `progress`, if set, is called after each render with the
/// number done and of all. Throws Error for options out of range.
SceneAgreement compare_engines(const Scene& scene, const AgreementOptions& options,
                               const std::function<void(std::size_t, std::size_t)>& progress = {});

}  // namespace twinray
