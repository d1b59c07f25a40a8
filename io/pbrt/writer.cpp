// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/writer.h"

#include <fmt/format.h>

#include "core/shading_map.h"
#include "io/first_coordinates.h"
#include "io/output_file.h"
#include "io/pbrt/text.h"
#include "io/pbrt/writer_camera.h"
#include "io/pbrt/writer_light.h"
#include "io/pbrt/writer_material.h"
#include "io/pbrt/writer_media.h"
#include "io/pbrt/writer_texture.h"
#include "io/ply/ply.h"

namespace twinray {
namespace {

/// pbrt's outside is where shading normals point, and ours where the corners go around: normals that point
/// to the other side are turned.
Mesh with_outward_normals(Mesh mesh) {
  const auto count = std::uint32_t(mesh.normals.size());
  bool is_turned = false;
  for (std::size_t i = 0; i < mesh.normal_indices.size(); ++i) {
    const Triangle& t = mesh.triangles[i];
    const Vec3 facet =
        cross(mesh.positions[t[1]] - mesh.positions[t[0]], mesh.positions[t[2]] - mesh.positions[t[0]]);
    Vec3 sum;
    for (const std::uint32_t index : mesh.normal_indices[i]) sum += mesh.normals[index];
    if (!(dot(facet, sum) < 0)) continue;
    if (!is_turned)
      for (std::uint32_t k = 0; k < count; ++k) mesh.normals.push_back(-mesh.normals[k]);
    is_turned = true;
    for (std::uint32_t& index : mesh.normal_indices[i]) index += count;
  }
  return mesh;
}

/// Writes the shapes, which name materials that stand before them.
class Shapes {
 public:
  Shapes(const Scene& scene, const PbrtMaterialTexts& materials, const PbrtMediaWriter& media,
         PbrtTextureWriter& textures, SceneOutput& output)
      : scene_(scene), materials_(materials), media_(media), textures_(textures), output_(output) {}

  std::string text() {
    const Geometry& geometry = *scene_.geometry;
    add(geometry.direct_shapes());
    for (std::size_t i = 0; i < geometry.prototypes().size(); ++i) {
      text_ += fmt::format("ObjectBegin \"{}\"\n", object_name(i));
      add(geometry.prototypes()[i]);
      text_ += "ObjectEnd\n";
    }
    for (const auto& [prototype, to_world] : geometry.instances())
      text_ += fmt::format("AttributeBegin\n{}ObjectInstance \"{}\"\nAttributeEnd\n",
                           pbrt_transform(to_world), object_name(prototype));
    return std::move(text_);
  }

 private:
  static std::string object_name(std::size_t prototype) { return fmt::format("object {}", prototype); }

  void add(ShapeRange range) {
    for (std::uint32_t shape = range.first; shape < range.end(); ++shape) add(shape);
  }

  void add(std::uint32_t shape) {
    const ShapeBinding& binding = scene_.bindings[shape];
    text_ += pbrt_comment(std::visit([](const auto& s) { return s.name; }, scene_.geometry->shapes()[shape]));
    text_ += "AttributeBegin\n" + media_.interface_of(shape) +
             fmt::format("NamedMaterial {}\n", pbrt_string(materials_.names[binding.material]));
    if (binding.light != no_light) text_ += pbrt_area_light(scene_, binding.light, output_);
    const std::string alpha = alpha_of(binding);
    if (const SphereSet* set = scene_.geometry->sphere_set(shape)) {
      name_coordinates(binding, set->spheres.size());
      for (const Sphere& sphere : set->spheres) add_sphere(sphere, alpha);
    } else {
      add_mesh(shape, alpha);
    }
    text_ += "AttributeEnd\n";
  }

  std::string alpha_of(const ShapeBinding& binding) {
    if (binding.alpha == no_texture) return "";
    const auto* constant = std::get_if<ConstantTexture>(&scene_.textures[binding.alpha].model);
    if (constant) return pbrt_real("alpha", constant->value.r);
    return pbrt_texture("alpha", textures_.named(binding.alpha, PbrtTextureKind::number));
  }

  /// pbrt's coordinates go around the z axis, ours are octahedral.
  void name_coordinates(const ShapeBinding& binding, std::size_t spheres) {
    for (std::size_t i = 0; i < spheres; ++i) {
      if (is_textured(scene_, binding))
        output_.losses.add("the texture of a sphere lies as pbrt's spheres have it",
                           "the textures of {} spheres lie as pbrt's spheres have them");
      if (is_anisotropic(scene_.materials[binding.material]))
        output_.losses.add("the facets of a sphere lie as pbrt's spheres have them",
                           "the facets of {} spheres lie as pbrt's spheres have them");
    }
  }

  /// One without a radius shows nothing, and is an error there.
  void add_sphere(const Sphere& sphere, const std::string& alpha) {
    if (!(sphere.radius > 0)) return;
    const Vec3& c = sphere.center;
    text_ += pbrt_transform(Transform::translation(double(c.x), double(c.y), double(c.z))) +
             "Shape \"sphere\"" + pbrt_real("radius", sphere.radius) + alpha + "\n";
  }

  void add_mesh(std::uint32_t shape, const std::string& alpha) {
    const auto write = [geometry = scene_.geometry, shape](const std::string& path) {
      write_file(path, ply_bytes(with_outward_normals(*geometry->mesh(shape))));
    };
    text_ += "Shape \"plymesh\"" +
             pbrt_word("filename", output_.add(fmt::format("-pbrt-{}.ply", shape), write)) + alpha + "\n";
  }

  const Scene& scene_;
  const PbrtMaterialTexts& materials_;
  const PbrtMediaWriter& media_;
  PbrtTextureWriter& textures_;
  SceneOutput& output_;
  std::string text_;
};

}  // namespace

WrittenScene written_pbrt(const SceneToWrite& input, const std::string& path) {
  SceneOutput output(path);
  const auto scene = by_first_coordinates(input.scene, output.losses);
  PbrtTextureWriter textures(*scene, output);
  const std::string view = pbrt_view(input, output);
  const PbrtMaterialTexts materials = pbrt_materials(*scene, textures, output);
  const std::string lights = pbrt_lights(*scene, output);
  const PbrtMediaWriter media(*scene, materials.names, output.losses);
  const std::string shapes = Shapes(*scene, materials, media, textures, output).text();
  WrittenScene written = output.finish(media.view() + view + "WorldBegin\n" + media.world() + textures.text +
                                       materials.text + lights + shapes);
  written.scene = scene;
  return written;
}

}  // namespace twinray
