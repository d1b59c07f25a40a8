// SPDX-License-Identifier: Apache-2.0
#include "core/surface_model.h"

#include <bit>

#include "core/hash.h"
#include "core/textured_material.h"

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

std::uint32_t material_at(const Scene& scene, const SurfacePoint& point) {
  std::uint32_t index = scene.bindings[point.shape].material;
  for (;;) {
    const Material& material = scene.materials[index];
    if (!std::holds_alternative<Mix>(material.model)) return index;
    const SurfaceModel model = textured_model(material, scene.textures, texture_point(point));
    const Mix& mix = std::get<Mix>(model);
    index = random_at(point, index) < mix.amount ? mix.second : mix.first;
  }
}

}  // namespace twinray
