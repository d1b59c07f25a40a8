// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/writer_media.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/encloses.h"
#include "io/pbrt/text.h"

namespace twinray {
namespace {

std::string size_text(const DensityGrid& grid) {
  const auto& [nx, ny, nz] = grid.size();
  return pbrt_integer("nx", nx) + pbrt_integer("ny", ny) + pbrt_integer("nz", nz);
}

std::string grid_text(const char* name, const DensityGrid& grid) {
  const auto& [nx, ny, nz] = grid.size();
  std::string text = fmt::format("\n  \"float {}\" [", name);
  for (int z = 0; z < nz; ++z)
    for (int y = 0; y < ny; ++y)
      for (int x = 0; x < nx; ++x)
        text += fmt::format("{}{}", x % 16 == 0 ? "\n    " : " ", grid.value(x, y, z));
  return text + " ]";
}

/// What the factor of a grid's light is that does not say one.
bool is_pbrts_own_factor(const DensityGrid& factor, const DensityGrid& density) {
  return factor.size() == DensityGrid::Size{1, 1, 1} && factor.value(0, 0, 0) == 1 &&
         factor.to_unit() == density.to_unit();
}

/// Where the transform is the identity.
class MediumText {
 public:
  MediumText(const Scene& scene, const Interior& interior, Losses& losses)
      : scene_(scene), interior_(interior), losses_(losses) {}

  std::string statement(const std::string& name) {
    if (interior_.density == no_density) return make(name, "homogeneous", even_glow());
    const DensityGrid& grid = *scene_.densities[interior_.density];
    const std::string numbers = size_text(grid) + grid_text("density", grid) + glow_of(grid);
    return pbrt_transform(grid.to_unit().inverse()) + make(name, "uniformgrid", numbers) + "Identity\n";
  }

 private:
  std::string make(const std::string& name, const char* type, const std::string& rest) const {
    return fmt::format("MakeNamedMedium {}{}{}{}{}{}\n", pbrt_string(name), pbrt_word("type", type),
                       pbrt_rgb("sigma_a", interior_.absorption), pbrt_rgb("sigma_s", interior_.scattering),
                       interior_.anisotropy != 0 ? pbrt_real("g", interior_.anisotropy) : "", rest);
  }
  std::string even_glow() {
    if (!interior_.emits()) return "";
    if (interior_.glow.is_uneven())
      losses_.add("light of an even medium that is not even is written as if it were",
                  "lights of {} even media that are not even are written as if they were");
    return pbrt_rgb("Le", interior_.glow.radiance);
  }
  /// pbrt's grids of one medium have one size, and lie in one place.
  std::string grid_or_loss(const char* name, const DensityGrid& grid, const DensityGrid& density) {
    if (grid.size() == density.size() && grid.to_unit() == density.to_unit()) return grid_text(name, grid);
    losses_.add("where a medium emits light is left out: it does not go by the grid of its density",
                "where {} media emit light is left out: they do not go by the grids of their densities");
    return "";
  }
  std::string factor_text(const DensityGrid& density) {
    const std::uint32_t factor = interior_.glow.factor;
    if (factor != no_density && is_pbrts_own_factor(*scene_.densities[factor], density)) return "";
    constexpr const char* name = "Lescale";
    if (factor != no_density) return grid_or_loss(name, *scene_.densities[factor], density);
    const auto& [nx, ny, nz] = density.size();  // Without any it would be pbrt's own.
    const std::vector<float> ones(std::size_t(nx) * std::size_t(ny) * std::size_t(nz), 1);
    return grid_text(name, DensityGrid(density.size(), ones, density.to_unit()));
  }
  std::string glow_of(const DensityGrid& density) {
    const Glow& glow = interior_.glow;
    if (!interior_.emits()) return "";
    std::string text = factor_text(density);
    if (glow.temperature != no_density)
      text += grid_or_loss("temperature", *scene_.densities[glow.temperature], density);
    if (glow.temperature == no_density) return pbrt_rgb("Le", glow.radiance) + text;
    if (glow.radiance != Rgb{1, 1, 1})
      losses_.add("the factor of a medium's temperatures is left out",
                  "the factors of {} media's temperatures are left out");
    return text + pbrt_real("temperatureoffset", glow.temperature_offset) +
           pbrt_real("temperaturescale", glow.temperature_scale);
  }

  const Scene& scene_;
  const Interior& interior_;
  Losses& losses_;
};

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
    statements.emplace_back(
        atmosphere_,
        MediumText(scene, scene.materials[scene.atmosphere].interior, losses).statement(atmosphere_));
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
    statements.emplace_back(media_[i], MediumText(scene, material.interior, losses).statement(media_[i]));
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
