// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/shapes.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>

#include "io/gltf/document.h"
#include "io/gltf/uv_area.h"
#include "io/placed_mesh.h"

namespace twinray {
namespace {

/// Whether the file's bitangent is n x t, or against it: as its tangents say or, without these, its texture
/// coordinates. In a mirrored world it is the other way round.
bool is_mirrored(const GltfPrimitive& primitive, const std::vector<Vec2>& uvs, const Triangle& triangle) {
  if (!primitive.handedness.empty()) return primitive.handedness[triangle[0]] < 0;
  return uv_area(uvs, triangle) < 0;
}

std::string mesh_name(const tinygltf::Mesh& mesh, int index, std::size_t primitive) {
  const std::string name = mesh.name.empty() ? fmt::format("mesh {}", index) : mesh.name;
  return mesh.primitives.size() < 2 ? name : fmt::format("{}, primitive {}", name, primitive);
}

/// The primitive's mesh but for its triangles.
Mesh vertices_of(const GltfPrimitive& primitive, const std::string& name) {
  Mesh mesh;
  mesh.name = name;
  mesh.positions = primitive.positions;
  mesh.normals = primitive.normals;
  return mesh;
}

void set_triangles(Mesh& mesh, std::vector<Triangle> triangles) {
  if (!mesh.normals.empty()) mesh.normal_indices = triangles;
  if (!mesh.uvs.empty()) mesh.uv_indices = triangles;
  if (!mesh.second_uvs.empty()) mesh.second_uv_indices = triangles;
  mesh.triangles = std::move(triangles);
}

/// The mesh of some of the triangles, by their numbers.
Mesh part_of(Mesh mesh, const std::vector<std::size_t>& chosen) {
  for (auto* const list :
       {&mesh.triangles, &mesh.normal_indices, &mesh.uv_indices, &mesh.second_uv_indices}) {
    if (list->empty()) continue;
    std::vector<Triangle> kept;
    for (const std::size_t i : chosen) kept.push_back((*list)[i]);
    *list = std::move(kept);
  }
  return mesh;
}

}  // namespace

const std::optional<GltfPrimitive>& GltfShapes::primitive(int mesh, int index) {
  const auto [entry, is_new] = primitives_.try_emplace({mesh, index});
  if (is_new) entry->second = read_primitive(document_, mesh, index);
  return entry->second;
}

void GltfShapes::add(int node, const std::vector<Transform>& to_world, const GltfDeformation& deformation) {
  const tinygltf::Model& model = document_.model();
  const tinygltf::Node& source = model.nodes[std::size_t(node)];
  const tinygltf::Mesh& mesh = model.meshes[std::size_t(source.mesh)];
  const std::string own = mesh.name.empty() ? fmt::format("node {}", node) : mesh.name;
  assets.push_back(source.name.empty() ? own : source.name);
  shown_.push_back({node, source.mesh, std::uint32_t(assets.size() - 1), to_world, deformation});
}

std::size_t GltfShapes::triangles_of(int mesh) {
  std::size_t triangles = 0;
  for (std::size_t i = 0; i < document_.model().meshes[std::size_t(mesh)].primitives.size(); ++i)
    if (const auto& made = primitive(mesh, int(i))) triangles += made->triangles.size();
  return triangles;
}

std::set<int> GltfShapes::shared_meshes() {
  std::map<int, std::size_t> times;
  for (const Shown& shown : shown_)
    if (shown.deformation.is_none()) times[shown.mesh] += shown.to_world.size();
  std::set<int> shared;
  for (const auto& [mesh, count] : times) {
    repeated += count > 1;
    if (are_stored_once(document_.context().options.instances, triangles_of(mesh), count))
      shared.insert(mesh);
  }
  return shared;
}

void GltfShapes::place_all() {
  const std::set<int> shared = shared_meshes();
  for (const Shown& shown : shown_)
    for (const Transform& to_world : shown.to_world)
      if (shown.deformation.is_none() && shared.count(shown.mesh) > 0)
        place_instance(shown, to_world);
      else
        place_mesh_of(shown, {to_world, shown.asset, to_world.determinant() < 0});
}

void GltfShapes::place_mesh_of(const Shown& shown, const Place& place) {
  const tinygltf::Mesh& mesh = document_.model().meshes[std::size_t(shown.mesh)];
  for (std::size_t i = 0; i < mesh.primitives.size(); ++i) {
    const auto& made = primitive(shown.mesh, int(i));
    if (!made) continue;
    const std::string name = mesh_name(mesh, shown.mesh, i);
    if (shown.deformation.is_none())
      this->place(*made, name, place);
    else
      this->place(deformed(document_, *made, shown.deformation), name, place);
  }
}

void GltfShapes::place_instance(const Shown& shown, const Transform& to_world) {
  const bool is_mirrored = to_world.determinant() < 0;
  if (!can_place(to_world)) return place_mesh_of(shown, {to_world, shown.asset, is_mirrored});
  const Prototype& prototype = prototype_of(shown, is_mirrored);
  if (!prototype.is_dark) place_mesh_of(shown, {to_world, shown.asset, is_mirrored, Which::glowing});
  if (prototype.box.is_empty()) return;
  check_reach(prototype.box, to_world, [&](const std::string& message) {
    document_.context().fail(fmt::format("/nodes/{}", shown.node), message);
  });
  instances.push_back({prototype.number, to_world});
}

const GltfShapes::Prototype& GltfShapes::prototype_of(const Shown& shown, bool is_mirrored) {
  const auto number = std::uint32_t(prototypes_.size());
  const auto [entry, is_new] =
      prototypes_.try_emplace({shown.mesh, is_mirrored}, Prototype{number, {}, true});
  Prototype& made = entry->second;
  if (!is_new) return made;
  const std::size_t first = parts.size(), left_out = left_out_;
  place_mesh_of(shown, {Transform{}, shown.asset, is_mirrored, Which::dark, number});
  for (std::size_t i = first; i < parts.size(); ++i) made.box.extend(bounds_of(parts[i].shape));
  made.is_dark = left_out_ == left_out;
  return made;
}

void GltfShapes::check_room(const Mesh& mesh, const std::string& pointer) {
  triangles_ += mesh.triangles.size();
  vertices_ += mesh.positions.size();
  if (triangles_ > max_triangles || vertices_ > max_triangles || parts.size() >= max_triangles)
    document_.context().fail(
        pointer, fmt::format("the scene has more than {} triangles, vertices or shapes, copies included",
                             max_triangles));
}

void GltfShapes::place(const GltfPrimitive& primitive, const std::string& name, const Place& place) {
  const auto set = materials_.uv_set(primitive.material);
  const auto uvs = set ? primitive.uvs.find(*set) : primitive.uvs.end();
  const auto second_set = materials_.second_uv_set(primitive.material);
  const auto second = second_set ? primitive.uvs.find(*second_set) : primitive.uvs.end();
  GltfUse use{.has_uvs = uvs != primitive.uvs.end()};
  for (const int each : materials_.uv_sets(primitive.material))
    if (!primitive.uvs.contains(each)) use.missing_sets.push_back(each);
  use.has_second_uvs = use.has_uvs && second != primitive.uvs.end();
  Mesh mesh = vertices_of(primitive, name);
  if (use.has_uvs) mesh.uvs = uvs->second;
  if (use.has_second_uvs) mesh.second_uvs = second->second;
  set_triangles(mesh, primitive.triangles);
  if (!use.has_uvs && materials_.is_unlit(primitive.material)) GltfColors::put_darkest_first(primitive, mesh);
  colors_.add(primitive, materials_.is_unlit(primitive.material), mesh, use);
  if (use.has_uvs && materials_.goes_by_tangents(primitive.material) && primitive.turned_uvs.contains(*set))
    document_.context().warn(primitive.pointer + "/attributes/TANGENT",
                             "these tangents are not those of the texture coordinates, by which normal maps "
                             "and brushed facets go");
  if (!use.has_uvs || !materials_.needs_handedness(primitive.material))
    return place_part(primitive, std::move(mesh), use, place);
  std::vector<std::size_t> sides[2];
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    sides[is_mirrored(primitive, uvs->second, mesh.triangles[i]) != place.is_mirrored].push_back(i);
  for (const bool is_mirrored_part : {false, true}) {
    if (sides[is_mirrored_part].empty()) continue;
    use.is_mirrored = is_mirrored_part;
    place_part(primitive, part_of(mesh, sides[is_mirrored_part]), use, place);
  }
}

void GltfShapes::place_part(const GltfPrimitive& primitive, Mesh mesh, GltfUse use, const Place& place) {
  const GltfSurface& surface = materials_.surface(primitive.material, use);
  if (place.which != Which::all && emits(surface.glow) != (place.which == Which::glowing)) {
    ++left_out_;
    return;
  }
  check_room(mesh, primitive.pointer);
  PlacedMesh placed = place_mesh(mesh, place.to_world, [&](const std::string& message) {
    document_.context().fail(primitive.pointer, message);
  });
  dropped_triangles += placed.dropped;
  replaced_normals += placed.without_normals;
  ScenePart part;
  part.material = surface.material;
  part.alpha = surface.alpha;
  part.asset = place.asset;
  part.prototype = place.prototype;
  part.light_name = placed.mesh.name;
  if (!document_.context().options.surfaces_only) part.glow = surface.glow;
  part.shape = std::move(placed.mesh);
  parts.push_back(std::move(part));
}

}  // namespace twinray
