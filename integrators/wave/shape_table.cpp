// SPDX-License-Identifier: Apache-2.0
#include "integrators/wave/shape_table.h"

#include "core/bsdf.h"

namespace twinray {

std::vector<ShapeEntry> shape_table(const Scene& scene) {
  std::vector<ShapeEntry> table;
  const Geometry& geometry = *scene.geometry;
  for (std::uint32_t shape = 0; shape < geometry.shapes().size(); ++shape) {
    const ShapeBinding& binding = scene.bindings[shape];
    ShapeEntry entry{.reflectance = lambert_reflectance(scene.materials[binding.material].model),
                     .emits = binding.light != no_light};
    if (const Mesh* mesh = geometry.mesh(shape); mesh && !mesh->triangles.empty()) {
      entry.positions = mesh->positions.data();
      entry.triangles = mesh->triangles.data();
      entry.facets = &geometry.facet(shape, 0);
      if (!mesh->normals.empty()) {
        entry.normals = mesh->normals.data();
        entry.normal_indices = mesh->normal_indices.data();
      }
    }
    table.push_back(entry);
  }
  return table;
}

}  // namespace twinray
