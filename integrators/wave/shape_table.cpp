// SPDX-License-Identifier: Apache-2.0
#include "integrators/wave/shape_table.h"

#include <algorithm>
#include <bit>

#include "core/scene_textures.h"
#include "core/shading_map.h"

namespace twinray {
namespace {

PatchTriangle patch_triangle(const Geometry& geometry, std::uint32_t shape, std::uint32_t triangle) {
  const Mesh& mesh = *geometry.mesh(shape);
  const auto& [a, b, c] = mesh.triangles[triangle];
  const Facet facet = geometry.facet(shape, triangle);
  return {mesh.positions[a], mesh.positions[b], mesh.positions[c], facet.normal, facet.offset};
}

Lamp lamp_of(const Geometry& geometry, const MeshLight& light, const LightPatch& patch, double area) {
  const auto bits = std::bit_cast<std::uint64_t>(area);
  Lamp lamp{.normal = patch.normal,
            .share = patch.share,
            .radiance = light.radiance,
            .is_parallelogram = patch.is_parallelogram,
            .side = std::uint32_t(light.side),
            .area_low = std::uint32_t(bits),
            .area_high = std::uint32_t(bits >> 32)};
  std::copy(patch.corners.begin(), patch.corners.end(), lamp.corners);
  for (std::size_t half = 0; half < 2; ++half) {
    lamp.triangles[half] = patch_triangle(geometry, light.shape, patch.triangles[half]);
    lamp.second_corner[half] = patch.corner_of[half][1];
    lamp.third_corner[half] = patch.corner_of[half][2];
  }
  return lamp;
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
  table.push_back({.is_lambert = false});
  return table;
}

bool has_second_uvs(const Scene& scene) {
  const std::vector<Shape>& shapes = scene.geometry->shapes();
  return !scene.textures.empty() && std::any_of(shapes.begin(), shapes.end(), [](const Shape& shape) {
    const auto* mesh = std::get_if<Mesh>(&shape);
    return mesh && !mesh->second_uvs.empty();
  });
}

bool has_placed_textures(const Scene& scene) {
  const std::vector<bool> placed = go_by_position(scene.textures);
  return std::find(placed.begin(), placed.end(), true) != placed.end();
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

std::vector<Lamp> lamp_table(const Scene& scene, const LightSet& lights) {
  // In order, so that groups come last.
  if (lights.sampled().empty() || lights.sampled().back() < lights.size()) return {};
  std::vector<Lamp> table(lights.size());
  for (std::uint32_t light = 0; light < lights.size(); ++light) {
    const std::vector<LightPatch>& patches = lights.patches(light).patches;
    if (patches.size() != 1 || lights.has_alpha(light)) continue;
    const auto& mesh = std::get<MeshLight>(lights.light(light).source);
    if (mesh.picture) continue;
    table[light] = lamp_of(*scene.geometry, mesh, patches[0], lights.triangles(light).total());
  }
  return table;
}

}  // namespace twinray
