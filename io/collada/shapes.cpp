// SPDX-License-Identifier: Apache-2.0
#include "io/collada/shapes.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/collada/instance.h"

namespace twinray {
namespace {

std::size_t triangles_of(const ColladaGeometry& shape) {
  std::size_t triangles = 0;
  for (const ColladaPart& part : shape.parts) triangles += part.mesh.triangles.size();
  return triangles;
}

/// The set of texture coordinates that a part is seen by.
std::uint32_t uv_set_of(const ColladaPart& part, const ColladaBinding& binding) {
  const std::uint32_t wanted = binding.uv_set.value_or(part.uv_set);
  const bool is_there = std::any_of(part.more_uvs.begin(), part.more_uvs.end(),
                                    [&](const ColladaUvs& uvs) { return uvs.set == wanted; });
  return binding.material.is_textured && is_there ? wanted : part.uv_set;
}

/// Says which of several sets is taken where the one that is bound is not named, which the specification
/// leaves open, or not there.
void check_uv_set(const ColladaPart& part, const ColladaBinding& binding, ColladaDocument& document) {
  if (!binding.bind || part.more_uvs.empty()) return;
  const std::uint32_t taken = uv_set_of(part, binding);
  if (!binding.bind->attribute("input_set"))
    document.warn(*binding.bind,
                  fmt::format("the input_set is missing, and <{}> has {} sets of texture coordinates; set {} "
                              "is used",
                              part.element.name(), part.more_uvs.size() + 1, taken));
  else if (taken != *binding.uv_set)
    document.warn(*binding.bind, fmt::format("<{}> has no texture coordinates of the set {}; set {} is used",
                                             part.element.name(), *binding.uv_set, taken));
}

std::string name_of(const ColladaGeometry& shape, const ColladaPart& part, const std::string& name) {
  return shape.parts.size() > 1 && !part.symbol.empty() ? name + "/" + part.symbol : name;
}

}  // namespace

void ColladaShapes::show(const XmlElement& instance, const XmlElement& geometry,
                         std::shared_ptr<const ColladaGeometry> shape, const std::string& name,
                         const Transform& to_world) {
  warn_where_empty(geometry, *shape, document_);
  Shown shown{instance, std::move(shape), name, std::uint32_t(parts_.assets.size()) - 1, to_world, {}};
  for (const ColladaPart& part : shown.shape->parts)
    shown.bindings.push_back(part.mesh.triangles.empty()
                                 ? ColladaBinding{}  // It will be left out.
                                 : materials_.bound(instance, is_cs184() ? "" : part.symbol));
  shown_.push_back(std::move(shown));
}

ColladaShapes::Key ColladaShapes::key_of(const Shown& shown) {
  Key key{shown.shape.get(), {}};
  for (std::size_t i = 0; i < shown.bindings.size(); ++i)
    key.second.push_back(
        {shown.bindings[i].material.index, uv_set_of(shown.shape->parts[i], shown.bindings[i])});
  return key;
}

bool ColladaShapes::can_be_shared(const Shown& shown) const {
  return !is_cs184() && !shown.shape->parts.empty();
}

void ColladaShapes::place_all() {
  std::map<Key, std::size_t> times;
  for (const Shown& shown : shown_) repeated += ++times[key_of(shown)] == 2 && can_be_shared(shown);
  for (const Shown& shown : shown_) {
    const bool is_stored_once =
        can_be_shared(shown) &&
        are_stored_once(document_.options().instances, triangles_of(*shown.shape), times[key_of(shown)]);
    if (is_stored_once && can_place(shown.to_world))
      place_instance(shown);
    else
      place(shown);
  }
}

void ColladaShapes::place(const Shown& shown) {
  if (shown.shape->sphere_radius) add_sphere(shown);
  for (std::size_t i = 0; i < shown.shape->parts.size(); ++i) add_part(shown, i, shown.to_world);
}

/// What emits is copied.
void ColladaShapes::place_instance(const Shown& shown) {
  for (std::size_t i = 0; i < shown.bindings.size(); ++i)
    if (emits(shown.bindings[i].material.glow)) add_part(shown, i, shown.to_world);
  const Prototype& prototype = prototype_of(shown);
  if (prototype.box.is_empty()) return;
  check_reach(prototype.box, shown.to_world,
              [&](const std::string& message) { shown.instance.fail(message); });
  parts_.instances.push_back({prototype.number, shown.to_world});
}

const ColladaShapes::Prototype& ColladaShapes::prototype_of(const Shown& shown) {
  const auto number = std::uint32_t(prototypes_.size());
  const auto [entry, is_new] = prototypes_.try_emplace(key_of(shown), Prototype{number, {}});
  if (!is_new) return entry->second;
  const std::size_t first = parts_.shapes.size();
  for (std::size_t i = 0; i < shown.bindings.size(); ++i)
    if (!emits(shown.bindings[i].material.glow)) add_part(shown, i, Transform{}, number);
  for (std::size_t i = first; i < parts_.shapes.size(); ++i)
    entry->second.box.extend(bounds_of(parts_.shapes[i].shape));
  return entry->second;
}

/// The part's mesh with the texture coordinates that its material asks for.
const Mesh& ColladaShapes::mesh_with_uvs(const ColladaPart& part, const ColladaBinding& binding, Mesh& made) {
  if (!binding.material.is_textured) return part.mesh;
  if (part.mesh.uvs.empty()) {
    document_.warn(part.element, fmt::format("<{}> has no texture coordinates, which its texture "
                                             "needs; it has the color of the picture's lower left corner",
                                             part.element.name()));
    made = part.mesh;
    made.uvs = {{0, 0}};
    made.uv_indices.assign(made.triangles.size(), {0, 0, 0});
    return made;
  }
  check_uv_set(part, binding, document_);
  const std::uint32_t set = uv_set_of(part, binding);
  if (set == part.uv_set) return part.mesh;
  const auto uvs = std::find_if(part.more_uvs.begin(), part.more_uvs.end(),
                                [&](const ColladaUvs& each) { return each.set == set; });
  made = part.mesh;
  made.uvs = uvs->uvs;
  made.uv_indices = uvs->indices;
  return made;
}

void ColladaShapes::add_part(const Shown& shown, std::size_t index, const Transform& to_world,
                             std::optional<std::uint32_t> prototype) {
  const ColladaPart& part = shown.shape->parts[index];
  const ColladaBinding& binding = shown.bindings[index];
  Mesh own;
  PlacedMesh placed = is_cs184() ? place_cs184_mesh(part, to_world, shown.instance, document_, parts_.bounds)
                                 : place_mesh(mesh_with_uvs(part, binding, own), to_world, shown.instance);
  dropped_triangles += placed.dropped;
  triangles_ += placed.mesh.triangles.size();
  if (triangles_ > max_triangles)
    shown.instance.fail(fmt::format("the scene has more than {} triangles, copies included", max_triangles));
  if (placed.without_normals > 0)
    document_.warn(part.element,
                   fmt::format("{} corners have the normal 0 0 0; they take that of their triangle",
                               placed.without_normals));
  if (placed.mesh.triangles.empty())
    return document_.warn(part.element, fmt::format("<{}> holds no triangle that has an area; it is left out",
                                                    part.element.name()));
  placed.mesh.name = name_of(*shown.shape, part, shown.name);
  ScenePart made;
  made.material = binding.material.index;
  made.alpha = binding.material.alpha;
  made.light_name = placed.mesh.name;
  made.asset = shown.asset;
  made.prototype = prototype;
  made.glow = binding.material.glow;
  made.shape = std::move(placed.mesh);
  parts_.shapes.push_back(std::move(made));
}

void ColladaShapes::add_sphere(const Shown& shown) {
  const Sphere sphere = place_sphere(*shown.shape->sphere_radius, shown.to_world, shown.instance, document_);
  parts_.bounds.extend(sphere_bounds(sphere));
  const ColladaMaterial material = materials_.bound(shown.instance, "").material;
  parts_.shapes.push_back({.shape = SphereSet{shown.name, {sphere}},
                           .material = material.index,
                           .glow = {.radiance = mean_radiance(material.glow)},
                           .light_name = shown.name,
                           .asset = shown.asset,
                           .alpha = material.alpha});
}

}  // namespace twinray
