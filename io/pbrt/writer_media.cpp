// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/writer_media.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/encloses.h"
#include "io/pbrt/text.h"

namespace twinray {
namespace {

std::string grid_text(const DensityGrid& grid) {
  const auto& [nx, ny, nz] = grid.size();
  std::string text = pbrt_integer("nx", nx) + pbrt_integer("ny", ny) + pbrt_integer("nz", nz);
  text += "\n  \"float density\" [";
  for (int z = 0; z < nz; ++z)
    for (int y = 0; y < ny; ++y)
      for (int x = 0; x < nx; ++x)
        text += fmt::format("{}{}", x % 16 == 0 ? "\n    " : " ", grid.value(x, y, z));
  return text + " ]";
}

/// Where the transform is the identity.
std::string medium_text(const Scene& scene, const std::string& name, const Interior& interior) {
  const auto statement = [&](const char* type, const std::string& grid) {
    return fmt::format("MakeNamedMedium {}{}{}{}{}{}\n", pbrt_string(name), pbrt_word("type", type),
                       pbrt_rgb("sigma_a", interior.absorption), pbrt_rgb("sigma_s", interior.scattering),
                       interior.anisotropy != 0 ? pbrt_real("g", interior.anisotropy) : "", grid);
  };
  if (interior.density == no_density) return statement("homogeneous", "");
  const DensityGrid& grid = *scene.densities[interior.density];
  return pbrt_transform(grid.to_unit().inverse()) + statement("uniformgrid", grid_text(grid)) + "Identity\n";
}

/// The media inside and outside of shapes.
std::string between(const std::string& inside, const std::string& outside) {
  return fmt::format("MediumInterface {} {}\n", pbrt_string(inside), pbrt_string(outside));
}

/// On the surface of a shape; there is one.
Vec3 some_point(const Shape& shape) {
  if (const auto* const set = std::get_if<SphereSet>(&shape))
    return set->spheres[0].center + Vec3{set->spheres[0].radius, 0, 0};
  const Mesh& mesh = std::get<Mesh>(shape);
  return mesh.positions[mesh.triangles[0][0]];
}

bool has_points(const Shape& shape) {
  if (const auto* const set = std::get_if<SphereSet>(&shape)) return !set->spheres.empty();
  return !std::get<Mesh>(shape).triangles.empty();
}

}  // namespace

PbrtMediaWriter::PbrtMediaWriter(const Scene& scene, const std::vector<std::string>& names, Losses& losses)
    : scene_(scene), media_(names.size()) {
  std::vector<std::pair<std::string, std::string>> statements;  // By the medium's name.
  if (scene.atmosphere != no_material) {
    atmosphere_ = "around all shapes";
    statements.emplace_back(atmosphere_,
                            medium_text(scene, atmosphere_, scene.materials[scene.atmosphere].interior));
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Material& material = scene.materials[i];
    if (names[i].empty()) continue;
    if (material.interior.priority != 0)
      losses.add("the priority of a body that overlaps others is left out",
                 "the priorities of {} materials of bodies that overlap are left out");
    if (is_black(material.interior.extinction()) || !lets_light_in(material)) continue;
    media_[i] = "within " + names[i];
    if (first_.empty()) first_ = media_[i];
    statements.emplace_back(media_[i], medium_text(scene, media_[i], material.interior));
  }
  const ShapeRange direct = scene.geometry->direct_shapes();
  for (std::uint32_t shape = direct.first; shape < direct.end(); ++shape) {
    const std::uint32_t material = scene.bindings[shape].material;
    const bool is_body = !media_[material].empty() || scene.materials[material].interior.is_clear;
    if (is_body && has_points(scene.geometry->shapes()[shape]))
      bodies_.push_back({shape, scene.geometry->bounds(shape), media_[material]});
  }
  std::stable_sort(bodies_.begin(), bodies_.end(), [](const Body& a, const Body& b) {
    return length(a.box.extent()) < length(b.box.extent());
  });
  const std::string at_camera = around(scene.camera.position, direct.end());
  for (const auto& [name, text] : statements) (name == at_camera ? view_ : world_) += text;
  if (!at_camera.empty()) view_ += between("", at_camera);
  if (!at_camera.empty() || !atmosphere_.empty()) world_ += between(atmosphere_, atmosphere_);
}

const std::string& PbrtMediaWriter::around(const Vec3& point, std::uint32_t shape) const {
  for (const Body& body : bodies_)
    if (body.shape != shape && body.box.contains(Aabb{point, point}) &&
        encloses(scene_.geometry->shapes()[body.shape], point))
      return body.medium;
  return atmosphere_;
}

std::string PbrtMediaWriter::interface_of(std::uint32_t shape) const {
  const std::uint32_t material = scene_.bindings[shape].material;
  const std::string& inside = media_[material];
  const bool is_clear = scene_.materials[material].interior.is_clear;
  const Shape& own = scene_.geometry->shapes()[shape];
  if ((inside.empty() && !is_clear) || !has_points(own)) return "";
  // A prototype stands anywhere.
  const bool is_direct = shape < scene_.geometry->direct_shapes().end();
  const std::string& outside = is_direct ? around(some_point(own), shape) : atmosphere_;
  // What is clear says so by something outside that is not.
  if (is_clear && inside.empty() && outside.empty()) return first_.empty() ? "" : between("", first_);
  return between(inside, outside);
}

}  // namespace twinray
