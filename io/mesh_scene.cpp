// SPDX-License-Identifier: Apache-2.0
#include "io/mesh_scene.h"

#include <fmt/format.h>

#include <utility>

#include "io/default_camera.h"
#include "io/placed_mesh.h"

namespace twinray {

void repair_mesh(Mesh& mesh, MeshRepairs& repairs) {
  PlacedMesh placed{std::move(mesh)};
  turn_normals(placed.mesh, Transform{});
  clean_up(placed);
  repairs.dropped_triangles += placed.dropped;
  repairs.replaced_normals += placed.without_normals;
  mesh = std::move(placed.mesh);
}

LoadedScene mesh_scene(std::vector<ScenePart> parts, Scene rest, const MeshRepairs& repairs,
                       std::vector<Instance> instances) {
  LoadedScene loaded{.scene = assemble(std::move(parts), std::move(rest), std::move(instances))};
  loaded.scene.camera = default_camera(loaded.scene.geometry->bounds());
  loaded.wants_light = loaded.scene.lights.empty();
  SceneSummary& summary = loaded.summary;
  summary.unit_name.clear();
  summary.dropped_triangles = repairs.dropped_triangles;
  if (repairs.replaced_normals > 0)
    summary.notes.push_back(
        fmt::format("{} shading normals have no direction; those of their triangles stand for them",
                    repairs.replaced_normals));
  count_scene(loaded.scene, summary);
  return loaded;
}

}  // namespace twinray
