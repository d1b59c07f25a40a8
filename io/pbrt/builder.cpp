// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/alpha_test.h"

#include "core/angle.h"
#include "core/mesh_area.h"
#include "core/radiance.h"
#include "core/shading_map.h"
#include "io/encloses.h"
#include "io/placed_mesh.h"

namespace twinray {
namespace {

double area_of(const Shape& shape) {
  double area = 0;
  if (const auto* set = std::get_if<SphereSet>(&shape))
    for (const Sphere& sphere : set->spheres)
      area += 4 * pi_double * double(sphere.radius) * double(sphere.radius);
  if (const auto* mesh = std::get_if<Mesh>(&shape))
    for (const Triangle& triangle : mesh->triangles) area += area_vector(*mesh, triangle).area();
  return area;
}

void check_coordinates(const Shape& shape, const PbrtPlace& place) {
  const auto is_near = [](const Vec3& p) { return is_finite(p) && max_abs(p) <= max_coordinate; };
  bool is_good = true;
  if (const auto* set = std::get_if<SphereSet>(&shape))
    for (const Sphere& sphere : set->spheres)
      is_good = is_good && is_near(sphere.center) && sphere.radius <= max_coordinate;
  if (const auto* mesh = std::get_if<Mesh>(&shape))
    for (const Vec3& p : mesh->positions) is_good = is_good && is_near(p);
  if (!is_good)
    place.fail(fmt::format("a coordinate of this shape lies beyond +-{:g}", double(max_coordinate)));
}

/// The texture coordinates that pbrt gives each triangle of a mesh without any.
void add_default_uvs(Mesh& mesh) {
  mesh.uvs = {{0, 0}, {1, 0}, {1, 1}};
  mesh.uv_indices.assign(mesh.triangles.size(), {0, 1, 2});
}

/// Whether light may get through a surface that has no inside of its own. Within others no medium is seen.
bool is_no_body(const SurfaceModel& model) {
  const auto* const sheet = std::get_if<Dielectric>(&model);
  const auto* const layers = std::get_if<Principled>(&model);
  return std::holds_alternative<Mix>(model) || std::holds_alternative<DiffuseTransmission>(model) ||
         std::holds_alternative<Hair>(model) || (sheet && sheet->is_thin) ||
         (layers && layers->geometry_thin_walled);
}

/// What a surface of OpenPBR emits along its normal: a coat tints it, and keeps what it reflects.
Rgb along_normal(const Principled& m) {
  const float root = (m.coat_ior - 1) / (m.coat_ior + 1);
  const Rgb through = m.coat_color * (1 - root * root);
  return m.emission_color * m.emission_luminance * (white * (1 - m.coat_weight) + through * m.coat_weight);
}

/// Within what film and lights can hold.
Rgb bounded(const Rgb& radiance, const PbrtPlace& place, WarningList& warnings) {
  if (max_component(radiance) <= max_radiance) return radiance;
  place.warn(warnings, fmt::format("a radiance of {:g} is taken as {:g}, the most that a picture can hold",
                                   max_component(radiance), max_radiance));
  return {std::min(radiance.r, max_radiance), std::min(radiance.g, max_radiance),
          std::min(radiance.b, max_radiance)};
}

/// Of lights and of media that emit.
void expose(Scene& scene, float exposure) {
  for (Light& light : scene.lights) scale_light(light.source, exposure);
  for (Material& material : scene.materials) {
    Rgb& glow = material.interior.glow.radiance;
    glow = glow * exposure;
  }
}

}  // namespace

void PbrtBuilder::add_shape(const std::string& type, const PbrtParameters& parameters,
                            const PbrtState& state) {
  context_.has_fibres = std::holds_alternative<Hair>(materials_.materials[state.material].model);
  auto shape = read_shape(type, parameters, context_);
  const std::uint32_t alpha = materials_.textures.alpha(parameters);
  if (!shape) return;
  if (shape->mesh.name.empty()) shape->mesh.name = fmt::format("{}, line {}", type, parameters.place().line);
  // A surface that is not there has two sides that are alike: turned around, it has the media turned.
  const bool is_turned = state.is_reversed && materials_.is_interface(state.material);
  // With the same medium on both sides it divides nothing: whatever is around it goes on within it.
  const bool divides_media = state.medium_inside != state.medium_outside;
  const auto& [within, without] = !divides_media ? std::pair<PbrtMediumPointer, PbrtMediumPointer>()
                                  : is_turned    ? std::pair(state.medium_outside, state.medium_inside)
                                                 : std::pair(state.medium_inside, state.medium_outside);
  const std::uint32_t asset = object_ ? std::uint32_t(assets_.size()) - 1 : no_asset;
  const bool is_dark = state.area_light && materials_.is_interface(state.material);
  if (is_dark)
    parameters.place().warn(context_.warnings, "an area light on an interface is left out, as pbrt does");
  const Part part{std::make_shared<const PbrtShape>(std::move(*shape)),
                  state.space.transform,
                  state.is_reversed && !is_turned && !context_.has_fibres,  // These have no sides.
                  state.material,
                  may_dim(within) || may_dim(without),
                  within,
                  without,
                  is_dark ? nullptr : state.area_light,
                  alpha,
                  parameters.place(),
                  asset};
  if (object_)
    object_->parts.push_back(part);
  else if (is_passed(part))
    passed_.push_back(part);
  else
    place(part, part.to_world, placed_);
}

bool PbrtBuilder::is_passed(const Part& part) const { return materials_.is_interface(part.material); }

void PbrtBuilder::end_object() {
  std::stable_partition(object_->parts.begin(), object_->parts.end(),
                        [&](const Part& part) { return !is_passed(part); });
  object_ = nullptr;
}

void PbrtBuilder::check_room(const Part& part) {
  triangles_ += part.shape->mesh.triangles.size();
  if (triangles_ > max_triangles || placed_.shapes.size() >= max_triangles)
    part.place.fail(
        fmt::format("the scene has more than {} triangles or shapes, copies included", max_triangles));
}

void PbrtBuilder::place(const Part& part, const Transform& to_world, Placed& placed) {
  const bool emits = part.light && !context_.options.surfaces_only;
  const bool is_nothing = part.alpha != no_texture && materials_.textures.is_at_most(part.alpha, 0);
  if (!emits && (is_nothing || (materials_.is_interface(part.material) && !part.is_filled))) return;
  check_room(part);
  // A sphere of our own has no poles, by which pbrt's coordinates go.
  const bool as_mesh = (emits && part.light->is_two_sided) || needs_uvs(part);
  Shape shape = place_shape(*with_uvs(part), to_world, part.is_reversed, as_mesh, account_);
  check_coordinates(shape, part.place);
  placed.shapes.push_back(std::move(shape));
  ShapeBinding binding{part.material, no_light, part.alpha, part.asset};
  if (emits) add_emission(part, binding);
  if (part.is_filled)
    placed.fillings.emplace(placed.bindings.size(), Filling{part.within, part.without, part.place});
  placed.bindings.push_back(binding);
}

bool PbrtBuilder::emits(const Part& part) const { return part.light || !is_black(glow_of(part.material)); }

/// Of a mix, the mean of its parts.
Rgb PbrtBuilder::glow_of(std::uint32_t material) const {
  const SurfaceModel& model = materials_.materials[material].model;
  if (const auto* surface = std::get_if<Principled>(&model)) return along_normal(*surface);
  const auto* parts = std::get_if<Mix>(&model);
  if (!parts) return {};
  return glow_of(parts->first) * (1 - parts->amount) + glow_of(parts->second) * parts->amount;
}

bool PbrtBuilder::is_textured(std::uint32_t material) const {
  const Material& made = materials_.materials[material];
  const auto* mix = std::get_if<Mix>(&made.model);
  const auto by_coordinates = [&](const TextureUse& use) {
    return materials_.textures.needs_coordinates(use.texture);
  };
  return std::any_of(made.textures.begin(), made.textures.end(), by_coordinates) || needs_tangents(made) ||
         (mix && (is_textured(mix->first) || is_textured(mix->second)));
}

bool PbrtBuilder::needs_uvs(const Part& part) const {
  const bool has_holes = part.alpha != no_texture && materials_.textures.needs_coordinates(part.alpha);
  return has_holes || is_textured(part.material) || (part.light && part.light->picture);
}

std::shared_ptr<const PbrtShape> PbrtBuilder::with_uvs(const Part& part) const {
  const Mesh& mesh = part.shape->mesh;
  if (mesh.triangles.empty() || !mesh.uvs.empty() || !needs_uvs(part)) return part.shape;
  auto shape = std::make_shared<PbrtShape>(*part.shape);
  add_default_uvs(shape->mesh);
  return shape;
}

/// A mesh emits from its front, which is pbrt's outside.
void PbrtBuilder::add_emission(const Part& part, ShapeBinding& binding) {
  const double area = area_of(placed_.shapes.back());
  const Rgb radiance =
      bounded(part.light->radiance_of(area, part.shape->pieces), part.place, context_.warnings);
  if (is_black(radiance)) return;
  const EmissionSide side = part.light->is_two_sided ? EmissionSide::both : EmissionSide::front;
  binding.light =
      add_shape_light(fmt::format("area light, line {}", part.place.line),
                      {std::uint32_t(placed_.shapes.size() - 1), radiance, side, part.light->picture});
}

std::uint32_t PbrtBuilder::add_shape_light(const std::string& name, const MeshLight& light) {
  if (std::holds_alternative<SphereSet>(placed_.shapes[light.shape]))
    shape_lights_.push_back({name, SphereLight{light.shape, light.radiance}});
  else
    shape_lights_.push_back({name, light});
  return std::uint32_t(shape_lights_.size() - 1);
}

std::uint32_t PbrtBuilder::add_filled(std::uint32_t material, const Interior& filling) {
  std::vector<Material>& materials = materials_.materials;
  materials.push_back(materials[material]);
  Interior& interior = materials.back().interior;
  const bool is_clear = filling == Interior{};
  if (!is_clear) {
    const std::int32_t priority = interior.priority;
    interior = filling;
    interior.priority = priority;
  }
  interior.is_clear = is_black(interior.extinction());
  return std::uint32_t(materials.size() - 1);
}

void PbrtBuilder::fill_interiors() {
  std::map<std::pair<std::uint32_t, PbrtMediumPointer>, std::uint32_t> filled;
  for (const auto& [shape, filling] : placed_.fillings) {
    const Interior interior = filling_of(filling.medium);
    std::uint32_t& material = placed_.bindings[shape].material;
    const Material& surface = materials_.materials[material];
    if (is_no_body(surface.model) && interior != Interior{})
      filling.place.warn(
          context_.warnings,
          "a medium is rendered within a dielectric, an interface or a clear openpbr alone, not here");
    if (!lets_light_in(surface)) continue;
    const auto [entry, is_new] = filled.try_emplace({material, filling.medium}, 0);
    if (is_new) entry->second = add_filled(material, interior);
    material = entry->second;
  }
}

/// The outermost shape around the camera says what is around it, too; without one the camera does.
std::uint32_t PbrtBuilder::add_atmosphere(std::size_t direct_shapes) {
  PbrtMediumPointer medium = around_camera_;
  float largest = 0;
  for (const auto& [index, filling] : placed_.fillings) {
    if (index >= direct_shapes) break;
    const Shape& shape = placed_.shapes[index];
    const float size = length(bounds_of(shape).extent());
    if (size > largest && encloses(shape, camera_)) medium = filling.outside, largest = size;
  }
  const Interior filling = filling_of(medium);
  if (filling == Interior{}) return no_material;
  materials_.materials.push_back(
      {.name = "what is around all shapes", .model = Interface{}, .interior = filling});
  return std::uint32_t(materials_.materials.size() - 1);
}

void PbrtBuilder::add_glow() {
  for (std::uint32_t shape = 0; shape < placed_.bindings.size(); ++shape) {
    ShapeBinding& binding = placed_.bindings[shape];
    const Material& material = materials_.materials[binding.material];
    const Rgb glow = glow_of(binding.material);
    if (is_black(glow) || binding.light != no_light || context_.options.surfaces_only) continue;
    binding.light = add_shape_light(material.name, {shape, glow, EmissionSide::both});
  }
}

void PbrtBuilder::add_light(const std::string& type, const PbrtParameters& parameters,
                            const PbrtState& state) {
  const auto light = read_light(type, parameters, state.space.transform, context_);
  if (light && !context_.options.surfaces_only)
    lights_.push_back({fmt::format("{} light, line {}", type, parameters.place().line), *light});
}

void PbrtBuilder::begin_object(const std::string& name, const PbrtPlace& place) {
  if (object_) place.fail("an object stands within another one; ObjectEnd belongs between them");
  if (objects_.count(name) > 0) place.fail(fmt::format("the object \"{}\" is defined a second time", name));
  object_ = &objects_[name];
  assets_.push_back(name);
}

void PbrtBuilder::add_instance(const std::string& name, const Transform& to_world, const PbrtPlace& place) {
  const auto object = objects_.find(name);
  if (object_) place.fail("an instance stands within an object, which pbrt does not have either");
  if (object == objects_.end()) {
    std::vector<std::string_view> known;
    for (const auto& entry : objects_) known.push_back(entry.first);
    const std::string nearest = nearest_name(name, known);
    place.fail(fmt::format("no object \"{}\" is defined before this{}", name,
                           nearest.empty() ? "" : fmt::format("; \"{}\" is the nearest one", nearest)));
  }
  object->second.shown.push_back({to_world, place});
}

Instancing PbrtBuilder::place_objects() {
  Placed shared;
  Instancing instancing;
  for (const std::string& name : assets_) place_object(objects_.at(name), shared, instancing);
  const std::size_t direct = placed_.shapes.size();
  for (ShapeRange& prototype : instancing.prototypes) prototype.first += std::uint32_t(direct);
  for (Shape& shape : shared.shapes) placed_.shapes.push_back(std::move(shape));
  for (const ShapeBinding& binding : shared.bindings) placed_.bindings.push_back(binding);
  for (const auto& [shape, filling] : shared.fillings) placed_.fillings.emplace(direct + shape, filling);
  return instancing;
}

bool PbrtBuilder::is_shared(const Object& object) const {
  std::size_t primitives = 0;
  for (const Part& part : object.parts)
    primitives += part.shape->sphere_radius > 0 ? 1 : part.shape->mesh.triangles.size();
  return are_stored_once(context_.options.instances, primitives, object.shown.size());
}

void PbrtBuilder::place_object(const Object& object, Placed& shared, Instancing& instancing) {
  const bool is_stored_once = is_shared(object);
  ShapeRange prototype{std::uint32_t(shared.shapes.size()), 0};
  if (is_stored_once)
    for (const Part& part : object.parts)
      if (!emits(part)) place(part, part.to_world, shared);
  prototype.count = std::uint32_t(shared.shapes.size()) - prototype.first;
  Aabb box;
  for (std::uint32_t i = prototype.first; i < prototype.end(); ++i) box.extend(bounds_of(shared.shapes[i]));
  for (const ShownAt& shown : object.shown) {
    const bool is_instance = prototype.count > 0 && can_place(shown.to_world);
    for (const Part& part : object.parts)
      if (!is_instance || emits(part)) place(part, shown.to_world * part.to_world, placed_);
    if (!is_instance) continue;
    check_reach(box, shown.to_world, [&](const std::string& message) { shown.place.fail(message); });
    instancing.instances.push_back({std::uint32_t(instancing.prototypes.size()), shown.to_world});
  }
  if (prototype.count > 0) instancing.prototypes.push_back(prototype);
}

LoadedScene PbrtBuilder::finish(float exposure) {
  materials_.check_all_made();
  media_.check_all_made();
  for (const Part& part : passed_) place(part, part.to_world, placed_);
  const std::size_t direct_shapes = placed_.shapes.size();
  Instancing instancing = place_objects();
  fill_interiors();
  add_glow();
  const std::uint32_t atmosphere = add_atmosphere(direct_shapes);
  LoadedScene loaded;
  Scene& scene = loaded.scene;
  scene.lights = std::move(shape_lights_);
  scene.lights.insert(scene.lights.end(), lights_.begin(), lights_.end());
  scene.atmosphere = atmosphere;
  scene.bindings = std::move(placed_.bindings);
  scene.assets = std::move(assets_);
  scene.materials = std::move(materials_.materials);
  if (exposure != 1) {
    expose(scene, exposure);
    context_.notes.push_back(fmt::format(
        "all light of the file is times {:g}, the film's exposure (shutter x iso / 100)", exposure));
  }
  scene.textures = std::move(materials_.textures.textures);
  scene.densities = std::move(media_.densities);
  scene.geometry = std::make_shared<const Geometry>(
      cut_out(std::move(placed_.shapes), scene.bindings, scene.textures, std::move(instancing)));
  check_scene(scene);
  loaded.summary.dropped_triangles = account_.dropped_triangles;
  for (const auto& [name, object] : objects_) loaded.summary.repeated += object.shown.size() > 1;
  if (account_.replaced_normals > 0)
    context_.notes.push_back(
        fmt::format("{} shading normals have no direction; those of their triangles stand for them",
                    account_.replaced_normals));
  count_scene(scene, loaded.summary);
  return loaded;
}

}  // namespace twinray
