// SPDX-License-Identifier: Apache-2.0
#include "core/surface_model.h"

#include <bit>

#include "core/hash.h"

namespace twinray {
namespace {

/// In [0, 1): a hash of a point and the material that asks.
float random_at(const SurfacePoint& point, std::uint32_t material) {
  std::uint64_t hash = mix((std::uint64_t(point.shape) << 32 | material) + hash_step);
  for (int axis = 0; axis < 3; ++axis)
    hash = mix(hash + std::bit_cast<std::uint32_t>(point.position[axis]) * index_step);
  return float(hash >> 40) * 0x1p-24f;
}

}  // namespace

const SurfaceModel& model_at(const Scene& scene, const SurfacePoint& point) {
  std::uint32_t material = scene.bindings[point.shape].material;
  while (const auto* mix = std::get_if<Mix>(&scene.materials[material].model))
    material = random_at(point, material) < mix->amount ? mix->second : mix->first;
  return scene.materials[material].model;
}

}  // namespace twinray
