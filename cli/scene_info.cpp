// SPDX-License-Identifier: Apache-2.0
#include "cli/scene_info.h"

#include <set>

#include "core/measured_brdf.h"
#include "io/exchange/writer.h"

namespace twinray {
namespace {

template <typename Element>
std::uint64_t bytes_of(const std::vector<Element>& elements) {
  return elements.size() * sizeof(Element);
}

/// What Geometry keeps of a shape.
std::uint64_t bytes_of(const Shape& shape) {
  if (const auto* const set = std::get_if<SphereSet>(&shape)) return bytes_of(set->spheres);
  const Mesh& mesh = std::get<Mesh>(shape);
  return bytes_of(mesh.positions) + bytes_of(mesh.triangles) + bytes_of(mesh.normals) +
         bytes_of(mesh.normal_indices) + bytes_of(mesh.uvs) + bytes_of(mesh.uv_indices) +
         bytes_of(mesh.second_uvs) + bytes_of(mesh.second_uv_indices);
}

std::size_t triangles_of(const Shape& shape) {
  const auto* const mesh = std::get_if<Mesh>(&shape);
  return mesh ? mesh->triangles.size() : 0;
}

std::vector<MaterialInfo> materials_of(const Scene& scene) {
  std::vector<MaterialInfo> materials;
  for (const Material& material : scene.materials)
    materials.push_back({material.name, type_of(material.model), material.textures.size(), 0, 0});
  for (std::uint32_t shape = 0; shape < scene.bindings.size(); ++shape) {
    MaterialInfo& material = materials[scene.bindings[shape].material];
    ++material.shapes;
    material.triangles += triangles_of(scene.geometry->shapes()[shape]);
  }
  return materials;
}

MediaInfo media_of(const Scene& scene) {
  MediaInfo media{.has_atmosphere = scene.atmosphere != no_material};
  for (const Material& material : scene.materials) {
    media.subsurface += has_subsurface(material);
    const Interior& interior = material.interior;
    if (is_black(interior.extinction())) continue;
    ++(is_black(interior.scattering) ? media.absorbing : media.scattering);
    media.uneven += interior.density != no_density;
    media.glowing += interior.emits();
  }
  return media;
}

std::vector<PictureInfo> pictures_of(const Scene& scene) {
  std::vector<PictureInfo> pictures;
  for (const Texture& texture : scene.textures)
    if (const auto* const image = std::get_if<ImageTexture>(&texture.model)) {
      std::uint64_t texels = 0;
      for (int i = 0; i < image->image->levels(); ++i) {
        const MipLevel level = image->image->level(i);
        texels += std::uint64_t(level.width) * std::uint64_t(level.height);
      }
      const MipLevel whole = image->image->level(0);
      pictures.push_back({texture.name, whole.width, whole.height, texels * sizeof(Rgb)});
    }
  return pictures;
}

/// The picture that a light shines by; null where it has none.
struct PictureOf {
  const Image* operator()(const MeshLight& light) const { return light.picture.get(); }
  const Image* operator()(const EnvironmentLight& light) const { return light.map.get(); }
  const Image* operator()(const GoniometricLight& light) const { return light.map.get(); }
  const Image* operator()(const ProjectionLight& light) const { return light.picture.get(); }
  template <typename Other>
  const Image* operator()(const Other&) const {
    return nullptr;
  }
};

/// Lights that share a picture keep it once.
std::uint64_t light_picture_bytes(const Scene& scene) {
  std::set<const Image*> pictures;
  for (const Light& light : scene.lights)
    if (const Image* const picture = std::visit(PictureOf{}, light.source)) pictures.insert(picture);
  std::uint64_t sum = 0;
  for (const Image* const picture : pictures) sum += bytes_of(picture->pixels);
  return sum;
}

/// Materials that share a measurement keep it once.
std::uint64_t measurement_bytes(const Scene& scene) {
  std::set<const MeasuredBrdf*> measurements;
  for (const Material& material : scene.materials)
    if (const auto* const measured = std::get_if<Measured>(&material.model))
      measurements.insert(measured->brdf.get());
  std::uint64_t sum = 0;
  for (const MeasuredBrdf* const brdf : measurements) sum += brdf->bytes();
  return sum;
}

}  // namespace

SceneInfo scene_info(const std::string& name, const LoadedScene& loaded) {
  const Scene& scene = loaded.scene;
  SceneInfo info;
  info.scene = name;
  info.summary = loaded.summary;
  info.bounds = scene.geometry->bounds();
  for (const Shape& shape : scene.geometry->shapes()) {
    info.geometry_bytes += bytes_of(shape);
    if (!std::visit([](const auto& s) { return s.is_opaque; }, shape))
      info.cut_out_triangles += triangles_of(shape);
  }
  info.geometry_bytes += scene.geometry->instances().size() * (sizeof(Instance) + sizeof(PlacedInstance));
  info.light_picture_bytes = light_picture_bytes(scene);
  for (const auto& grid : scene.densities) info.density_bytes += grid->bytes();
  info.measurement_bytes = measurement_bytes(scene);
  info.media = media_of(scene);
  info.materials = materials_of(scene);
  info.pictures = pictures_of(scene);
  for (const Diagnostic& warning : loaded.warnings) info.warnings.push_back(warning.text());
  return info;
}

}  // namespace twinray
