// SPDX-License-Identifier: Apache-2.0
#include "io/collada/nodes.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/collada/transform.h"

namespace twinray {
namespace {

std::string instance_name(const XmlElement& node, const XmlElement& geometry) {
  const std::string name = display_name(node);
  return name == "unnamed" ? display_name(geometry) : name;
}

Transform even_scaling(double factor) { return Transform::scaling(factor, factor, factor); }

constexpr int no_object = 3;

/// Which object of a node CS184's program prefers: the least.
int object_rank(const XmlElement& child) {
  if (child.is("instance_camera")) return 0;
  if (child.is("instance_light")) return 1;
  return child.is("instance_geometry") ? 2 : no_object;
}

}  // namespace

void ColladaNodes::walk(const XmlElement& visual_scene, const Transform& to_world) {
  if (!is_cs184()) layers_ = SceneLayers(visual_scene);
  controllers_.emplace(visual_scene, document_);
  for (const XmlElement& node : visual_scene.children("node")) {
    parts.assets.push_back(display_name(node));
    visit(node, visual_scene, {to_world, document_.space_of(document_.root())});
  }
  shapes_.place_all();
}

void ColladaNodes::visit(const XmlElement& node, const XmlElement& from, const Placement& outside) {
  const bool hides = !is_cs184() && is_hidden(node);
  hiding_ += hides;
  const ColladaSpace& space = document_.space_of(node, from, outside.space);
  const Placement placement{
      outside.to_world * conversion(space, outside.space) * read_node_transform(node, document_), space};
  for (const XmlElement& child : is_cs184() ? cs184_children(node) : node.children()) {
    if (names_nothing(child)) continue;
    instance(node, child, placement);
    if (child.is("instance_node")) visit(document_.resolve(child, "url", "node"), child, placement);
    if (child.is("node")) visit(child, node, placement);
  }
  hiding_ -= hides;
}

std::vector<XmlElement> ColladaNodes::cs184_children(const XmlElement& node) {
  std::vector<XmlElement> children, objects;
  for (const XmlElement& child : node.children()) {
    if (child.is("node") || child.is("instance_node")) children.push_back(child);
    if (object_rank(child) < no_object) objects.push_back(child);
    if (child.is("instance_controller"))
      document_.warn(child, "CS184's program reads no controllers; this one is left out");
  }
  std::stable_sort(objects.begin(), objects.end(),
                   [](const XmlElement& a, const XmlElement& b) { return object_rank(a) < object_rank(b); });
  for (std::size_t i = 0; i < objects.size(); ++i)
    if (i == 0)
      children.push_back(objects[i]);
    else
      document_.warn(objects[i],
                     "a node has one object in CS184's program, its camera, else its light, else "
                     "its geometry; this one is left out");
  return children;
}

/// <instance_light/>, with a warning.
bool ColladaNodes::names_nothing(const XmlElement& instance) {
  if (instance.name().rfind("instance_", 0) != 0 || !instance.attribute("url").value_or("").empty())
    return false;
  document_.warn(instance,
                 fmt::format("this <{}> has no url that names something; it is left out", instance.name()));
  return true;
}

/// Programs hide the cameras that they make for themselves; these serve all the same.
void ColladaNodes::instance(const XmlElement& node, const XmlElement& child, const Placement& placement) {
  if (child.is("instance_camera")) return add_camera(node, child, placement);
  const bool is_light = child.is("instance_light"), is_geometry = child.is("instance_geometry"),
             is_controller = child.is("instance_controller");
  if (!is_light && !is_geometry && !is_controller) return;
  if (hiding_ > 0 || (!is_light && !layers_.show(node))) return hidden.push_back(display_name(node));
  if (is_light) add_light(child, placement.to_world);
  if (is_geometry) add_geometry(node, child, placement);
  if (is_controller) add_controller(node, child, placement);
}

std::shared_ptr<const ColladaGeometry> ColladaNodes::geometry(const XmlElement& element) {
  auto& known = geometries_[element];
  if (!known) known = std::make_shared<const ColladaGeometry>(read_geometry(element, document_));
  return known;
}

void ColladaNodes::add_geometry(const XmlElement& node, const XmlElement& instance,
                                const Placement& placement) {
  const XmlElement element = document_.resolve(instance, "url", "geometry");
  const ColladaSpace& space = document_.space_of(element, instance, placement.space);
  shapes_.show(instance, element, geometry(element), instance_name(node, element),
               placement.to_world * conversion(space, placement.space));
}

/// What joints have moved is in the coordinates of the scene.
void ColladaNodes::add_controller(const XmlElement& node, const XmlElement& instance,
                                  const Placement& placement) {
  PosedGeometry posed = controllers_->pose(instance);
  const ColladaSpace& space = posed.is_in_scene
                                  ? document_.space_of(document_.root())
                                  : document_.space_of(posed.geometry, instance, placement.space);
  shapes_.show(instance, posed.geometry,
               std::make_shared<const ColladaGeometry>(std::move(posed.shape.geometry)),
               instance_name(node, posed.geometry),
               placement.to_world * conversion(space, placement.space) * posed.to_node);
}

void ColladaNodes::add_light(const XmlElement& instance, const Transform& to_world) {
  if (document_.options().surfaces_only) return;
  const auto element = document_.resolve_or_warn(instance, "url", "light");
  if (!element || document_.is_empty(*element)) return;
  auto light = read_light(*element, instance, to_world, document_);
  if (!light) return;
  if (const std::string name = display_name(*element);
      document_.options().interpretation == Interpretation::standard &&
      !document_.options().attenuation_as_file && lacks_attenuation(*element) &&
      std::find(without_attenuation.begin(), without_attenuation.end(), name) == without_attenuation.end())
    without_attenuation.push_back(name);
  if (auto* area = std::get_if<AreaLight>(&*light)) parts.area_lights.push_back(*area);
  if (auto* other = std::get_if<Light>(&*light)) parts.lights.push_back(*other);
}

/// A camera looks into the depth of its space, whose up is its up: where its <asset> has another axis than
/// its node, it is turned so that it does. Its lengths are in its own unit.
void ColladaNodes::add_camera(const XmlElement& node, const XmlElement& instance,
                              const Placement& placement) {
  const auto element = document_.resolve_or_warn(instance, "url", "camera");
  if (!element || document_.is_empty(*element)) return;
  ColladaSpace space = document_.space_of(*element, instance, placement.space);
  const double unit = space.unit_meters;
  space.unit_meters = placement.space.unit_meters;
  const Transform turn = conversion(placement.space, space), size = even_scaling(unit / space.unit_meters);
  cameras.push_back({*element, instance, node, placement.to_world * turn * size,
                     unit / document_.space_of(document_.root()).unit_meters});
}

}  // namespace twinray
