// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/writer.h"

#include <array>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/shading_map.h"
#include "io/first_coordinates.h"
#include "io/gltf/uv_area.h"
#include "io/gltf/writer_material.h"
#include "io/gltf/writer_view.h"
#include "io/joined_mesh.h"
#include "io/pbrt/quadric.h"
#include "io/turned_emitter.h"

namespace twinray {
namespace {

/// Its v runs downwards.
void flip(std::vector<Vec2>& uvs) {
  for (Vec2& uv : uvs) uv.y = 1 - uv.y;
}

/// Corners that go around the other way: the front becomes the back.
void turn(std::vector<Triangle>& triangles) {
  for (Triangle& triangle : triangles) std::swap(triangle[1], triangle[2]);
}

/// Writes the shapes: a node for each, and one for each instance.
class Shapes {
 public:
  Shapes(const Scene& scene, GltfFile& file) : scene_(scene), file_(file), materials_(scene, file) {}

  void add() {
    const Geometry& geometry = *scene_.geometry;
    for (std::uint32_t shape = 0; shape < geometry.direct_shapes().end(); ++shape) add_shape(shape);
    std::vector<bool> are_handed;
    for (const ShapeRange& range : geometry.prototypes()) are_handed.push_back(needs_handedness(range));
    for (const auto& [number, to_world] : geometry.instances()) {
      const ShapeRange& range = geometry.prototypes()[number];
      if (const auto mesh = prototype(range, are_handed[number] && to_world.determinant() < 0))
        file_.add_node(
            {{"name", asset_name(range.first)}, {"mesh", *mesh}, {"matrix", gltf_matrix(to_world)}});
    }
  }

 private:
  std::string shape_name(std::uint32_t shape) const {
    return std::visit([](const auto& s) { return s.name; }, scene_.geometry->shapes()[shape]);
  }
  /// Of what the shape belongs to, or its own.
  std::string asset_name(std::uint32_t shape) const {
    const std::uint32_t asset = scene_.bindings[shape].asset;
    return asset != no_asset ? scene_.assets[asset] : shape_name(shape);
  }

  /// Without a surface there is nothing to be seen.
  bool is_left_out(std::uint32_t shape) {
    const ShapeBinding& binding = scene_.bindings[shape];
    const bool is_open = std::holds_alternative<Interface>(scene_.materials[binding.material].model) &&
                         binding.light == no_light;
    if (is_open)
      file_.output.losses.add("a shape without a surface is left out",
                              "{} shapes without a surface are left out");
    return is_open;
  }

  /// Of an emitter whose back emits, which there the front does alone.
  bool is_turned(std::uint32_t shape) const {
    const std::uint32_t light = scene_.bindings[shape].light;
    const auto* mesh = light == no_light ? nullptr : std::get_if<MeshLight>(&scene_.lights[light].source);
    return mesh && mesh->side == EmissionSide::back;
  }

  bool needs_handedness(const ShapeRange& range) const {
    for (std::uint32_t shape = range.first; shape < range.end(); ++shape)
      if (materials_.needs_handedness(scene_.bindings[shape])) return true;
    return false;
  }

  /// Adds the mesh as one primitive. Where a normal map or a tangent lies mirrored the format turns it
  /// around, and one that is turned already belongs there: such triangles are a primitive of their own.
  /// `is_mirrored`: by the node.
  void add_primitives(const Mesh& mesh, std::uint32_t shape, GltfJson& primitives, bool is_mirrored = false) {
    JoinedMesh joined = join_corners(mesh);
    const std::vector<std::array<float, 4>> colors =
        materials_.vertex_colors(scene_.bindings[shape], joined.uvs);
    if (!colors.empty()) joined.uvs.clear();
    // What needs no coordinates here is a picture of one color there, which needs some.
    else if (joined.uvs.empty() && is_textured(scene_, scene_.bindings[shape]))
      joined.uvs.assign(joined.positions.size(), {});
    if (is_turned(shape)) {
      turn(joined.triangles);
      name_turned_emitter(scene_, std::get<MeshLight>(scene_.lights[scene_.bindings[shape].light].source),
                          file_.output.losses);
    }
    const bool is_handed = !joined.uvs.empty() && materials_.needs_handedness(scene_.bindings[shape]);
    std::vector<Triangle> sides[2];
    for (const Triangle& triangle : joined.triangles)
      sides[is_handed && (uv_area(joined.uvs, triangle) < 0) != is_mirrored].push_back(triangle);
    flip(joined.uvs);
    GltfJson attributes{{"POSITION", file_.vectors(joined.positions, true)}};
    if (!joined.normals.empty()) attributes["NORMAL"] = file_.vectors(joined.normals, false);
    if (!joined.uvs.empty()) attributes["TEXCOORD_0"] = file_.pairs(joined.uvs);
    if (!colors.empty()) attributes["COLOR_0"] = file_.colors(colors);
    for (const bool is_other_side : {false, true})
      if (const std::vector<Triangle>& triangles = sides[is_other_side]; !triangles.empty())
        primitives.push_back({{"attributes", attributes},
                              {"indices", file_.indices({triangles[0].data(), 3 * triangles.size()})},
                              {"material", materials_.material(scene_.bindings[shape], is_other_side)}});
  }

  GltfJson primitives(const Mesh& mesh, std::uint32_t shape) {
    GltfJson list = GltfJson::array();
    add_primitives(mesh, shape, list);
    return list;
  }

  std::size_t add_mesh(const std::string& name, const GltfJson& primitives) {
    return file_.add("meshes", {{"name", name}, {"primitives", primitives}});
  }

  void add_shape(std::uint32_t shape) {
    if (is_left_out(shape)) return;
    if (const SphereSet* set = scene_.geometry->sphere_set(shape)) return add_spheres(*set, shape);
    const Mesh& mesh = *scene_.geometry->mesh(shape);
    if (mesh.triangles.empty()) return;
    const std::size_t index = add_mesh(mesh.name, primitives(mesh, shape));
    file_.add_node({{"name", asset_name(shape)}, {"mesh", index}});
  }

  /// Ours have octahedral coordinates.
  void name_sphere(std::uint32_t shape) {
    file_.output.losses.add("a sphere is a mesh of 256 edges around",
                            "{} spheres are meshes of 256 edges around");
    const ShapeBinding& binding = scene_.bindings[shape];
    if (is_textured(scene_, binding))
      file_.output.losses.add("the texture of a sphere lies around its z axis",
                              "the textures of {} spheres lie around their z axes");
    if (is_anisotropic(scene_.materials[binding.material]))
      file_.output.losses.add("the facets of a sphere are longer around its z axis",
                              "the facets of {} spheres are longer around their z axes");
  }

  /// Nodes that scale one sphere of this material.
  void add_spheres(const SphereSet& set, std::uint32_t shape) {
    const std::size_t material = materials_.material(scene_.bindings[shape]);
    const auto [entry, is_new] = spheres_.try_emplace(material);
    if (is_new) entry->second = add_mesh(set.name, primitives(sphere_mesh({}), shape));
    for (const Sphere& sphere : set.spheres) {
      name_sphere(shape);
      const double r = shortest_decimal(sphere.radius);
      const Vec3& c = sphere.center;
      file_.add_node({{"name", asset_name(shape)},
                      {"mesh", entry->second},
                      {"translation", {shortest_decimal(c.x), shortest_decimal(c.y), shortest_decimal(c.z)}},
                      {"scale", {r, r, r}}});
    }
  }

  /// A sphere in place, as a part of a prototype.
  static Mesh placed(const Sphere& sphere) {
    Mesh mesh = sphere_mesh({});
    for (Vec3& p : mesh.positions) p = sphere.center + p * sphere.radius;
    return mesh;
  }

  /// One mesh of all shapes, made once; none where nothing of it is seen. `is_mirrored`: for instances that
  /// mirror it.
  std::optional<std::size_t> prototype(const ShapeRange& range, bool is_mirrored) {
    const auto [entry, is_new] = prototypes_.try_emplace({range.first, is_mirrored});
    if (is_new) entry->second = make_prototype(range, is_mirrored);
    return entry->second;
  }
  std::optional<std::size_t> make_prototype(const ShapeRange& range, bool is_mirrored) {
    GltfJson primitives = GltfJson::array();
    for (std::uint32_t shape = range.first; shape < range.end(); ++shape) {
      if (is_left_out(shape)) continue;
      if (const SphereSet* set = scene_.geometry->sphere_set(shape))
        for (const Sphere& sphere : set->spheres) {
          name_sphere(shape);
          add_primitives(placed(sphere), shape, primitives, is_mirrored);
        }
      else if (const Mesh& mesh = *scene_.geometry->mesh(shape); !mesh.triangles.empty())
        add_primitives(mesh, shape, primitives, is_mirrored);
    }
    if (primitives.empty()) return std::nullopt;
    return add_mesh(shape_name(range.first), primitives);
  }

  const Scene& scene_;
  GltfFile& file_;
  GltfMaterialWriter materials_;
  std::map<std::size_t, std::size_t> spheres_;  ///< The mesh of a material's spheres.
  /// By their first shape, and whether instances mirror them.
  std::map<std::pair<std::uint32_t, bool>, std::optional<std::size_t>> prototypes_;
};

}  // namespace

WrittenScene written_gltf(const SceneToWrite& input, const std::string& path) {
  SceneOutput output(path);
  GltfFile file(output, path.ends_with(".glb"));
  const auto scene = by_first_coordinates(input.scene, output.losses);
  add_gltf_camera(input, file);
  add_gltf_lights(*scene, file);
  Shapes(*scene, file).add();
  if (scene->atmosphere != no_material)
    output.losses.add("what fills the space around the camera is left out");
  WrittenScene written = file.finish();
  written.scene = scene;
  return written;
}

}  // namespace twinray
