// SPDX-License-Identifier: Apache-2.0
// Scene files by their extension, and generated scenes by their names: the one door for whoever wants a
// scene.
#pragma once
#include <string>

#include "io/load_options.h"
#include "io/loaded_scene.h"

namespace twinray {

/// Reads a scene file: COLLADA 1.4 or 1.5 (.dae, .zae), pbrt-v4 (.pbrt, .pbrt.gz), glTF 2.0 (.gltf, .glb),
/// Wavefront OBJ (.obj), a mesh (.ply, .ply.gz), or one of those that Assimp reads (.stl, .fbx, ...); or
/// makes a generated scene (io/generated/generated.h) of a name such as "generated:ball". Throws Error, with
/// the place in the file and what would be valid; so it does where no camera has the name that the options
/// ask for.
LoadedScene load_scene(const std::string& path, const LoadOptions& options = {});

/// Whether a file of this name is read as COLLADA.
bool is_collada(const std::string& path);

/// Whether a file of this name may say something about its picture (LoadedScene::defaults).
bool has_defaults(const std::string& path);

/// Whether a file is a scene, by its extension, and no mesh, of which scenes are made; one of pbrt's must
/// also begin a world, for parts of scenes have the same extension.
bool is_scene_file(const std::string& path);

}  // namespace twinray
