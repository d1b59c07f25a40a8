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

std::vector<FewTriangles> few_triangles(const Scene& scene, const LightSet& lights) {
  std::vector<FewTriangles> all(lights.size());
  for (std::uint32_t light = 0; light < lights.size(); ++light) {
    const auto* emitter = std::get_if<MeshLight>(&lights.light(light).source);
    const Distribution& areas = lights.triangles(light);
    if (!emitter || areas.size() > FewTriangles::most || areas.total() == 0) continue;
    const Mesh& mesh = *scene.geometry->mesh(emitter->shape);
    FewTriangles& few = all[light];
    few.size = areas.size();
    few.last = areas.last();
    for (std::uint32_t i = 0; i < few.size; ++i) {
      const auto& [a, b, c] = mesh.triangles[i];
      few.a[i] = mesh.positions[a];
      few.b[i] = mesh.positions[b];
      few.c[i] = mesh.positions[c];
      const Facet& facet = scene.geometry->facet(emitter->shape, i);
      few.normal[i] = facet.normal;
      few.offset[i] = facet.offset;
      few.sums[i + 1] = areas.sum_before(i + 1);
    }
  }
  return all;
}

}  // namespace twinray
