// SPDX-License-Identifier: Apache-2.0
#include "io/ply/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "io/gzip.h"
#include "io/mesh_scene.h"
#include "io/ply/reader.h"
#include "io/vertex_colors.h"

namespace twinray {

namespace {

/// The mesh's material, of the colours of its vertices.
void paint(PlyMesh& ply, Scene& scene) {
  Material& material = scene.materials[0];
  material.name = "colors of vertices";
  const std::vector<Rgb>& colors = ply.colors;
  if (std::all_of(colors.begin(), colors.end(), [&](const Rgb& color) { return color == colors[0]; })) {
    material.model = Lambert{colors[0]};
    return;
  }
  scene.textures.push_back(
      {material.name, draw_vertices(ply.mesh, [&](std::uint32_t i) { return colors[i]; })});
  material.textures.push_back({MaterialInput::reflectance, 0});
  set_drawn_uvs(ply.mesh);
}

}  // namespace

LoadedScene load_ply(const std::string& path, const LoadOptions& options) {
  options.add_file(path);
  PlyMesh read = read_ply(read_unpacked(path), path, PlyColors::read);
  read.mesh.name = std::filesystem::path(path).stem().string();
  Scene rest;
  rest.materials = {{"none", Lambert{}}};
  const bool is_painted = !read.colors.empty() && can_draw_vertices(read.mesh);
  if (is_painted) paint(read, rest);
  MeshRepairs repairs;
  repair_mesh(read.mesh, repairs);
  std::vector<ScenePart> parts(1);
  parts[0].shape = std::move(read.mesh);
  LoadedScene loaded = mesh_scene(std::move(parts), std::move(rest), repairs);
  if (read.flat_faces > 0)
    loaded.summary.notes.push_back(
        fmt::format("faces of less than three corners, left out: {}", read.flat_faces));
  for (const std::string& what : read.left_out) loaded.summary.notes.push_back(what + " are left out");
  if (!read.colors.empty() && !is_painted)
    loaded.summary.notes.push_back(
        "the mesh has too many triangles for the colors of its vertices: it is grey");
  return loaded;
}

}  // namespace twinray
