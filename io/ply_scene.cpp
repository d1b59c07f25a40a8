// SPDX-License-Identifier: Apache-2.0
#include "io/ply_scene.h"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "io/gzip.h"
#include "io/mesh_scene.h"
#include "io/ply_reader.h"

namespace twinray {

LoadedScene load_ply(const std::string& path, const LoadOptions& options) {
  options.add_file(path);
  PlyMesh read = read_ply(read_unpacked(path), path);
  read.mesh.name = std::filesystem::path(path).stem().string();
  MeshRepairs repairs;
  repair_mesh(read.mesh, repairs);
  std::vector<ScenePart> parts(1);
  parts[0].shape = std::move(read.mesh);
  Scene rest;
  rest.materials = {{"none", Lambert{}}};
  LoadedScene loaded = mesh_scene(std::move(parts), std::move(rest), repairs);
  if (read.flat_faces > 0)
    loaded.summary.notes.push_back(
        fmt::format("faces of less than three corners, left out: {}", read.flat_faces));
  return loaded;
}

}  // namespace twinray
