// SPDX-License-Identifier: Apache-2.0
#include "integrators/layer_records.h"

#include "core/surface.h"

namespace twinray {

void record_first_surface(const Scene& scene, const FirstSurface& surface, const RecordSpans& records,
                          std::size_t sample) {
  const auto& [hit, position, normal] = surface;
  if (records.has(Layer::geometric_normal))
    records[Layer::geometric_normal][sample] = {normal.x, normal.y, normal.z};
  if (records.has(Layer::depth)) records[Layer::depth][sample] = {hit.t, 0, 0};
  if (records.has(Layer::position)) records[Layer::position][sample] = {position.x, position.y, position.z};
  if (records.has(Layer::uv)) {
    const Vec2 uv = texture_coordinates(*scene.geometry, hit);
    records[Layer::uv][sample] = {uv.x, uv.y, 0};
  }
  const ShapeBinding& binding = scene.bindings[hit.mesh];
  if (records.has(Layer::ids))
    records[Layer::ids][sample] = {float(hit.mesh) + 1, float(binding.material) + 1,
                                   hit.instance == no_instance ? 0 : float(hit.instance) + 1};
  if (records.has(Layer::object_matte)) records[Layer::object_matte][sample] = record_id(hit.mesh + 1);
  if (records.has(Layer::material_matte))
    records[Layer::material_matte][sample] = record_id(binding.material + 1);
  if (records.has(Layer::asset_matte))
    records[Layer::asset_matte][sample] = record_id(asset_of(scene, hit.mesh) + 1);
}

bool shows_first_surface(const RecordSpans& records) {
  using enum Layer;
  constexpr Layer of_first_surface[]{geometric_normal, depth,          position,   uv, ids,
                                     object_matte,     material_matte, asset_matte};
  return std::any_of(std::begin(of_first_surface), std::end(of_first_surface),
                     [&](Layer layer) { return records.has(layer); });
}

bool has_environment(const Scene& scene) {
  const auto is_environment = [](const Light& light) {
    return std::holds_alternative<EnvironmentLight>(light.source);
  };
  return std::any_of(scene.lights.begin(), scene.lights.end(), is_environment);
}

}  // namespace twinray
