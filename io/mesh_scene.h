// SPDX-License-Identifier: Apache-2.0
// Scenes of formats that hold meshes, and neither cameras nor lights.
#pragma once
#include <cstddef>
#include <vector>

#include "io/loaded_scene.h"
#include "io/scene_part.h"

namespace twinray {

/// What had to be done to meshes.
struct MeshRepairs {
  std::size_t dropped_triangles = 0, replaced_normals = 0;
};

/// Takes out triangles without area and vertices that are not used, and makes all shading normals unit
/// vectors.
void repair_mesh(Mesh& mesh, MeshRepairs& repairs);

/// Such a scene, seen as a whole in three-quarter view; where nothing emits, it is to be lit by default
/// (LoadedScene::wants_light). Throws Error as assemble() does.
LoadedScene mesh_scene(std::vector<ScenePart> parts, Scene rest, const MeshRepairs& repairs,
                       std::vector<Instance> instances = {});

}  // namespace twinray
