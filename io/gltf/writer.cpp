// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/writer.h"

#include <array>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "io/gltf/writer_material.h"
#include "io/gltf/writer_view.h"
#include "io/joined_mesh.h"
#include "io/pbrt/quadric.h"

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
    std::vector<std::optional<std::size_t>> prototypes;
    for (const ShapeRange& range : geometry.prototypes()) prototypes.push_back(prototype(range));
    for (const auto& [number, to_world] : geometry.instances())
      if (prototypes[number]) {
        const ShapeRange& range = geometry.prototypes()[number];
        file_.add_node({{"name", asset_name(range.first)},
                        {"mesh", *prototypes[number]},
                        {"matrix", gltf_matrix(to_world)}});
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

  GltfJson primitive(const Mesh& mesh, std::uint32_t shape) {
    JoinedMesh joined = join_corners(mesh);
    const std::vector<std::array<float, 4>> colors =
        materials_.vertex_colors(scene_.bindings[shape], joined.uvs);
    if (!colors.empty()) joined.uvs.clear();
    flip(joined.uvs);
    if (is_turned(shape)) turn(joined.triangles);
    GltfJson attributes{{"POSITION", file_.vectors(joined.positions, true)}};
    if (!joined.normals.empty()) attributes["NORMAL"] = file_.vectors(joined.normals, false);
    if (!joined.uvs.empty()) attributes["TEXCOORD_0"] = file_.pairs(joined.uvs);
    if (!colors.empty()) attributes["COLOR_0"] = file_.colors(colors);
    const std::span<const std::uint32_t> corners(
        joined.triangles.empty() ? nullptr : joined.triangles[0].data(), 3 * joined.triangles.size());
    return {{"attributes", attributes},
            {"indices", file_.indices(corners)},
            {"material", materials_.material(scene_.bindings[shape])}};
  }

  std::size_t add_mesh(const std::string& name, const GltfJson& primitives) {
    return file_.add("meshes", {{"name", name}, {"primitives", primitives}});
  }

  void add_shape(std::uint32_t shape) {
    if (is_left_out(shape)) return;
    if (const SphereSet* set = scene_.geometry->sphere_set(shape)) return add_spheres(*set, shape);
    const Mesh& mesh = *scene_.geometry->mesh(shape);
    if (mesh.triangles.empty()) return;
    const std::size_t index = add_mesh(mesh.name, GltfJson::array({primitive(mesh, shape)}));
    file_.add_node({{"name", asset_name(shape)}, {"mesh", index}});
  }

  void name_sphere() {
    file_.output.losses.add("a sphere is a mesh of 256 edges around",
                            "{} spheres are meshes of 256 edges around");
  }

  /// Nodes that scale one sphere of this material.
  void add_spheres(const SphereSet& set, std::uint32_t shape) {
    const std::size_t material = materials_.material(scene_.bindings[shape]);
    const auto [entry, is_new] = spheres_.try_emplace(material);
    if (is_new) entry->second = add_mesh(set.name, GltfJson::array({primitive(sphere_mesh({}), shape)}));
    for (const Sphere& sphere : set.spheres) {
      name_sphere();
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

  /// One mesh of all shapes; none where nothing of it is seen.
  std::optional<std::size_t> prototype(const ShapeRange& range) {
    GltfJson primitives = GltfJson::array();
    for (std::uint32_t shape = range.first; shape < range.end(); ++shape) {
      if (is_left_out(shape)) continue;
      if (const SphereSet* set = scene_.geometry->sphere_set(shape))
        for (const Sphere& sphere : set->spheres) {
          name_sphere();
          primitives.push_back(primitive(placed(sphere), shape));
        }
      else if (const Mesh& mesh = *scene_.geometry->mesh(shape); !mesh.triangles.empty())
        primitives.push_back(primitive(mesh, shape));
    }
    if (primitives.empty()) return std::nullopt;
    return add_mesh(shape_name(range.first), primitives);
  }

  const Scene& scene_;
  GltfFile& file_;
  GltfMaterialWriter materials_;
  std::map<std::size_t, std::size_t> spheres_;  ///< The mesh of a material's spheres.
};

}  // namespace

WrittenScene written_gltf(const SceneToWrite& input, const std::string& path) {
  SceneOutput output(path);
  GltfFile file(output, path.ends_with(".glb"));
  add_gltf_camera(input, file);
  add_gltf_lights(input.scene, file);
  Shapes(input.scene, file).add();
  return file.finish();
}

}  // namespace twinray
