// SPDX-License-Identifier: Apache-2.0
#include "integrators/wave/shape_table.h"

#include <algorithm>

#include "core/shading_map.h"

namespace twinray {
namespace {

PatchTriangle patch_triangle(const Geometry& geometry, std::uint32_t shape, std::uint32_t triangle) {
  const Mesh& mesh = *geometry.mesh(shape);
  const auto& [a, b, c] = mesh.triangles[triangle];
  const Facet facet = geometry.facet(shape, triangle);
  return {mesh.positions[a], mesh.positions[b], mesh.positions[c], facet.normal, facet.offset};
}

}  // namespace

std::vector<ShapeEntry> shape_table(const Scene& scene) {
  std::vector<ShapeEntry> table;
  const Geometry& geometry = *scene.geometry;
  for (std::uint32_t shape = 0; shape < geometry.shapes().size(); ++shape) {
    const ShapeBinding& binding = scene.bindings[shape];
    const Material& material = scene.materials[binding.material];
    const auto* lambert = has_map(material) ? nullptr : std::get_if<Lambert>(&material.model);
    ShapeEntry entry{.reflectance = lambert ? lambert->reflectance : Rgb{},
                     .textured = material.textures.empty() ? nullptr : &material,
                     .is_lambert = lambert != nullptr,
                     .emits = binding.light != no_light};
    if (const Mesh* mesh = geometry.mesh(shape); mesh && !mesh->triangles.empty()) {
      entry.positions = mesh->positions.data();
      entry.triangles = mesh->triangles.data();
      if (!mesh->normals.empty()) {
        entry.normals = mesh->normals.data();
        entry.normal_indices = mesh->normal_indices.data();
      }
      if (!mesh->uvs.empty() && !scene.textures.empty()) {
        entry.uvs = mesh->uvs.data();
        entry.uv_indices = mesh->uv_indices.data();
      }
    }
    table.push_back(entry);
  }
  return table;
}

bool has_second_uvs(const Scene& scene) {
  const std::vector<Shape>& shapes = scene.geometry->shapes();
  return !scene.textures.empty() && std::any_of(shapes.begin(), shapes.end(), [](const Shape& shape) {
    const auto* mesh = std::get_if<Mesh>(&shape);
    return mesh && !mesh->second_uvs.empty();
  });
}

bool exceeds_cache(const Geometry& geometry) {
  constexpr std::size_t few = 4096;  // of some fifty bytes each, beside the wave's own
  std::size_t triangles = 0;
  for (std::uint32_t shape = 0; shape < geometry.shapes().size(); ++shape)
    if (const Mesh* mesh = geometry.mesh(shape)) triangles += mesh->triangles.size();
  return triangles > few;
}

std::vector<PatchTable> patch_tables(const Scene& scene, const LightSet& lights) {
  std::vector<PatchTable> tables(lights.size());
  for (std::uint32_t light = 0; light < lights.size(); ++light) {
    const std::vector<LightPatch>& patches = lights.patches(light).patches;
    if (patches.empty()) continue;
    tables[light].light = &lights.patches(light);
    const std::uint32_t shape = std::get<MeshLight>(lights.light(light).source).shape;
    for (std::size_t i = 0; i < patches.size(); ++i)
      for (std::size_t half = 0; half < 2; ++half)
        tables[light].triangles[i][half] = patch_triangle(*scene.geometry, shape, patches[i].triangles[half]);
  }
  return tables;
}

}  // namespace twinray
