// SPDX-License-Identifier: Apache-2.0
#include "accel/fastest_engine.h"

#include <fmt/format.h>

namespace twinray {
namespace {

/// Without vector instructions the eight boxes of a wide node are tested one after the other. Nanoseconds for
/// a ray, bvh-2, bvh and embree: Cornell box of 12 triangles 119, 161, 194; 60 triangles and spheres 146,
/// 206, 219; cow 453, 559, 386; CBbunny 300, 282, 336; CBdragon 599, 519, 580.
constexpr std::size_t binary_primitives = 1000, embree_primitives = 10'000;

std::string instruction_set(const BuildOptions& options) {
  return options.simd == "best" ? available_instruction_sets()[1] : options.simd;
}

}  // namespace

EngineChoice fastest_engine(const Geometry& geometry, const BuildOptions& options) {
  const std::string simd = instruction_set(options);
  if (simd != "scalar")
    return {
        named_engine("bvh", options),
        fmt::format("with {} it was the fastest on every scene measured, 1.3 to 2.3 times as fast as embree",
                    simd)};
  if (geometry.primitive_count() < binary_primitives)
    return {named_engine("bvh-2", options),
            fmt::format("without vector instructions it was the fastest on scenes of less than {} primitives",
                        binary_primitives)};
  if (geometry.primitive_count() < embree_primitives && find_engine("embree"))
    return {named_engine("embree", options),
            fmt::format("without vector instructions it was the fastest on a scene of {} to {} primitives",
                        binary_primitives, embree_primitives)};
  return {named_engine("bvh", options),
          "without vector instructions it was the fastest on most large scenes"};
}

}  // namespace twinray
