// SPDX-License-Identifier: Apache-2.0
#include "io/obj/scene.h"

#include <fmt/format.h>

#include <map>

#include "core/shading_map.h"
#include "io/facet_direction.h"
#include "io/input_file.h"
#include "io/mesh_scene.h"
#include "io/obj/material.h"
#include "io/polygon.h"
#include "io/scene_part.h"
#include "io/used_elements.h"
#include "io/vertex_colors.h"

namespace twinray {
namespace {

/// Corners as a mesh has them: each list with indices of its own.
struct CornerLists {
  std::vector<Triangle> positions, normals, uvs;
};

/// Adds the triangles of a face, whose corners begin at `first`.
void add_triangles(const ObjModel& model, std::span<const ObjCorner> corners, bool has_normals, bool has_uvs,
                   CornerLists& to) {
  std::vector<Vec3> positions;
  for (const ObjCorner& corner : corners) positions.push_back(model.positions[corner.position]);
  const auto add = [&](const std::array<std::uint32_t, 3>& triangle) {
    const ObjCorner &a = corners[triangle[0]], &b = corners[triangle[1]], &c = corners[triangle[2]];
    to.positions.push_back({a.position, b.position, c.position});
    if (has_normals) to.normals.push_back({a.normal, b.normal, c.normal});
    if (has_uvs) to.uvs.push_back({a.uv, b.uv, c.uv});
  };
  if (corners.size() == 3) return add({0, 1, 2});
  for (const auto& triangle : triangulate(positions)) add(triangle);
}

template <typename Element>
std::vector<std::uint32_t> take(const std::vector<Element>& from, std::vector<Triangle>& corners,
                                std::vector<Element>& to) {
  return take_used(
      from.size(), [&](std::uint32_t i) { return from[i]; }, corners, to);
}

/// A mesh, and the numbers that the model has for its positions; none where they are the same.
struct NumberedMesh {
  Mesh mesh;
  std::vector<std::uint32_t> numbers;
};

NumberedMesh mesh_of(const ObjModel& model, const ObjFaces& faces) {
  CornerLists lists;
  std::span<const ObjCorner> corners = faces.corners;
  for (const std::uint32_t size : faces.sizes) {
    add_triangles(model, corners.first(size), faces.has_normals, faces.has_uvs, lists);
    corners = corners.subspan(size);
  }
  Mesh mesh;
  mesh.name = !faces.group.empty() ? faces.group : !faces.object.empty() ? faces.object : model.name;
  mesh.triangles = std::move(lists.positions);
  mesh.normal_indices = std::move(lists.normals);
  mesh.uv_indices = std::move(lists.uvs);
  std::vector<std::uint32_t> numbers = take(model.positions, mesh.triangles, mesh.positions);
  if (faces.has_normals) take(model.normals, mesh.normal_indices, mesh.normals);
  if (faces.has_uvs) take(model.uvs, mesh.uv_indices, mesh.uvs);
  return {std::move(mesh), std::move(numbers)};
}

/// Whether the vertices of the faces have colors that are seen: those of a diffuse or principled material
/// without pictures.
bool is_painted(const ObjModel& model, const Mesh& mesh, const ObjSurface& surface,
                const ObjMaterials& materials) {
  const SurfaceModel& made = materials.materials[surface.material].model;
  const bool can_be = std::holds_alternative<Lambert>(made) || std::holds_alternative<Principled>(made);
  return can_be && !model.colors.empty() && !materials.is_textured(surface) && can_draw_vertices(mesh);
}

/// Numbers names in the order in which they come.
class Assets {
 public:
  std::uint32_t number(const std::string& name) {
    if (name.empty()) return no_asset;
    const auto [entry, is_new] = numbers_.try_emplace(name, std::uint32_t(names.size()));
    if (is_new) names.push_back(name);
    return entry->second;
  }
  std::vector<std::string> names;

 private:
  std::map<std::string, std::uint32_t> numbers_;
};

ScenePart part_of(const ObjModel& model, const ObjFaces& faces, ObjMaterials& materials, Assets& assets,
                  MeshRepairs& repairs) {
  ObjSurface surface = materials.surface(faces.material);
  auto [mesh, numbers] = mesh_of(model, faces);
  if (is_painted(model, mesh, surface, materials)) {
    surface = materials.painted(surface, draw_vertices(mesh, [&numbers = numbers, &model](std::uint32_t i) {
                                  return model.colors[numbers.empty() ? i : numbers[i]];
                                }));
    set_drawn_uvs(mesh);
  }
  repair_mesh(mesh, repairs);
  if (mesh.uvs.empty() && is_anisotropic(materials.materials[surface.material]))
    materials.warn(no_facet_direction);
  if (mesh.uvs.empty() && materials.is_textured(surface)) {
    mesh.uvs = {{0, 0}};
    mesh.uv_indices.assign(mesh.triangles.size(), {0, 0, 0});
  }
  ScenePart part;
  part.glow = surface.glow;
  part.light_name = mesh.name;
  part.shape = std::move(mesh);
  part.material = surface.material;
  part.alpha = surface.alpha;
  part.asset = assets.number(faces.object);
  return part;
}

/// Drops the materials that no part has, such as those whose faces are all painted.
void drop_unused(std::vector<Material>& materials, std::vector<ScenePart>& parts) {
  std::vector<Triangle> uses;
  for (const ScenePart& part : parts) uses.push_back({part.material, part.material, part.material});
  std::vector<Material> used;
  take(materials, uses, used);
  for (std::size_t i = 0; i < parts.size(); ++i) parts[i].material = uses[i][0];
  materials = std::move(used);
}

std::vector<std::string> notes_of(const ObjModel& model) {
  std::vector<std::string> notes = model.notes;
  if (model.small_faces > 0)
    notes.push_back(fmt::format("faces of less than three corners, left out: {}", model.small_faces));
  if (model.has_weights) notes.push_back("weights of vertices, behind their coordinates, are left out");
  return notes;
}

}  // namespace

LoadedScene make_scene(const ObjModel& model, const LoadOptions& options, WarningList& warnings) {
  ObjMaterials materials(model, options, warnings);
  Assets assets;
  MeshRepairs repairs;
  std::vector<ScenePart> parts;
  for (const ObjFaces& faces : model.faces)
    parts.push_back(part_of(model, faces, materials, assets, repairs));
  drop_unused(materials.materials, parts);
  Scene rest;
  rest.materials = std::move(materials.materials);
  rest.textures = std::move(materials.textures);
  rest.assets = std::move(assets.names);
  LoadedScene loaded = mesh_scene(std::move(parts), std::move(rest), repairs);
  for (std::string& note : notes_of(model)) loaded.summary.notes.push_back(std::move(note));
  loaded.warnings = warnings.items();
  return loaded;
}

LoadedScene load_obj(const std::string& path, const LoadOptions& options) {
  WarningList warnings(options.strict);
  const auto read = [&](const std::string& file) {
    options.add_file(file);
    return read_input_file(file, file == path ? "scene file" : "material file");
  };
  return make_scene(read_obj(path, read, warnings), options, warnings);
}

}  // namespace twinray
