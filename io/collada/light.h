// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <variant>

#include "core/geometry.h"
#include "core/light.h"
#include "core/transform.h"
#include "io/collada/document.h"

namespace twinray {

/// An area light in world space: the unit square [-1/2, 1/2]^2 of its node's x and y, facing the node's -z.
struct AreaLight {
  std::string name;
  Vec3 corners[4];  ///< In order around the rectangle; counter-clockwise from where the light goes.
  Rgb radiance;
};

/// The rectangle as a mesh of two triangles whose fronts emit.
Mesh area_light_mesh(const AreaLight& light);

using PlacedLight = std::variant<AreaLight, Light>;

/// Reads a <light> that an <instance_light> places, from its CGL technique if it has one, else from
/// <technique_common>, and puts it where the node's transform says. Point, spot and directional lights look
/// along the node's -z; by CS184's rules point lights do not fall off, directional ones come from the point
/// one unit in front of their node as seen from the origin, and spot lights are left out, with a warning.
/// Nothing, with a warning, for an area light without area. Throws Error for colors below 0, an attenuation
/// that is 0, a missing type.
/// A point or spot light without attenuation elements falls off by LoadOptions::attenuation_as_file.
std::optional<PlacedLight> read_light(const XmlElement& light, const XmlElement& instance,
                                      const Transform& to_world, ColladaDocument& document);

/// Whether it is a point or spot light that says nothing of its attenuation.
bool lacks_attenuation(const XmlElement& light);

}  // namespace twinray
