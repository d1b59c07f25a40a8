// SPDX-License-Identifier: Apache-2.0
#include "io/gltf_shapes.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>

#include "io/gltf_document.h"
#include "io/gltf_glow.h"
#include "io/placed_mesh.h"

namespace twinray {
namespace {

/// Twice the area of a triangle in texture coordinates: negative where they run the other way round.
float uv_area(const std::vector<Vec2>& uvs, const Triangle& t) {
  const Vec2 p = uvs[t[1]] - uvs[t[0]], q = uvs[t[2]] - uvs[t[0]];
  return p.x * q.y - p.y * q.x;
}

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
  mesh.triangles = std::move(triangles);
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
  for (std::size_t i = 0; i < mesh.primitives.size(); ++i) {
    const auto& made = primitive(source.mesh, int(i));
    if (!made) continue;
    const std::string name = mesh_name(mesh, source.mesh, i);
    if (deformation.is_none()) {
      for (const Transform& each : to_world) place(*made, name, each);
    } else {
      const GltfPrimitive moved = deformed(document_, *made, deformation);
      for (const Transform& each : to_world) place(moved, name, each);
    }
  }
}

void GltfShapes::check_room(const GltfPrimitive& primitive) {
  triangles_ += primitive.triangles.size();
  vertices_ += primitive.positions.size();
  if (triangles_ > max_triangles || vertices_ > max_triangles || parts.size() >= max_triangles)
    document_.context().fail(
        primitive.pointer,
        fmt::format("the scene has more than {} triangles, vertices or shapes, instances included",
                    max_triangles));
}

void GltfShapes::place(const GltfPrimitive& primitive, const std::string& name, const Transform& to_world) {
  check_room(primitive);
  const auto set = materials_.uv_set(primitive.material);
  const auto uvs = set ? primitive.uvs.find(*set) : primitive.uvs.end();
  GltfUse use{.has_uvs = uvs != primitive.uvs.end()};
  Mesh mesh = vertices_of(primitive, name);
  if (use.has_uvs) mesh.uvs = uvs->second;
  set_triangles(mesh, primitive.triangles);
  colors_.add(primitive, mesh, use);
  if (!use.has_uvs || !materials_.has_normal_map(primitive.material))
    return place_part(primitive, std::move(mesh), use, to_world);
  std::vector<Triangle> sides[2];
  const bool is_world_mirrored = to_world.determinant() < 0;
  for (const Triangle& triangle : primitive.triangles)
    sides[is_mirrored(primitive, uvs->second, triangle) != is_world_mirrored].push_back(triangle);
  for (const bool is_mirrored_part : {false, true}) {
    if (sides[is_mirrored_part].empty()) continue;
    use.is_mirrored = is_mirrored_part;
    set_triangles(mesh, std::move(sides[is_mirrored_part]));
    place_part(primitive, mesh, use, to_world);
  }
}

void GltfShapes::place_part(const GltfPrimitive& primitive, Mesh mesh, GltfUse use,
                            const Transform& to_world) {
  const GltfSurface& surface = materials_.surface(primitive.material, use);
  PlacedMesh placed = place_mesh(mesh, to_world, [&](const std::string& message) {
    document_.context().fail(primitive.pointer, message);
  });
  dropped_triangles += placed.dropped;
  replaced_normals += placed.without_normals;
  ScenePart part;
  part.material = surface.material;
  part.alpha = surface.alpha;
  part.asset = std::uint32_t(assets.size() - 1);
  part.light_name = placed.mesh.name;
  if (!document_.context().options.surfaces_only) add_emission(surface, primitive.pointer, placed.mesh, part);
  part.shape = std::move(placed.mesh);
  parts.push_back(std::move(part));
}

void GltfShapes::add_emission(const GltfSurface& surface, const std::string& pointer, Mesh& mesh,
                              ScenePart& part) {
  if (is_black(surface.radiance) || (surface.glow && is_black(mean_of(*surface.glow)))) return;
  part.radiance = surface.radiance;
  part.side = surface.side;
  if (!surface.glow) return;
  if (surface.may_move_uvs) move_into_square(mesh);
  part.picture = glow_over(surface, mesh.uvs);
  if (part.picture) return;
  part.radiance = surface.radiance * mean_of(*surface.glow);
  document_.context().warn(pointer,
                           "texture coordinates beyond one picture are not rendered where it emits: this "
                           "surface emits the picture's mean");
}

}  // namespace twinray
