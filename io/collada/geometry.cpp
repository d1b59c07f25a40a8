// SPDX-License-Identifier: Apache-2.0
#include "io/collada/geometry.h"

#include <fmt/format.h>

#include "io/collada/source.h"

namespace twinray {
namespace {

bool is_primitive(const XmlElement& element) {
  for (const char* name : {"triangles", "polylist", "polygons", "tristrips", "trifans"})
    if (element.is(name)) return true;
  return false;
}

/// The one primitive element that CS184's program would read; none where it would read nothing.
std::optional<XmlElement> only_part(const XmlElement& mesh) {
  const auto polylist = mesh.child("polylist");
  return polylist ? polylist : mesh.child("triangles");
}

/// The primitive elements that are read.
std::vector<XmlElement> parts_of(const XmlElement& mesh, ColladaDocument& document) {
  std::vector<XmlElement> parts;
  for (const XmlElement& element : mesh.children())
    if (is_primitive(element)) parts.push_back(element);
  const auto only = only_part(mesh);
  if (document.options().interpretation == Interpretation::standard || !only) return parts;
  for (const XmlElement& element : parts)
    if (!(element == *only))
      document.warn(element, fmt::format("CS184's program reads one <{}> of a mesh; this <{}> is left out",
                                         only->name(), element.name()));
  return {*only};
}

std::optional<XmlElement> mesh_of(const XmlElement& geometry) {
  const auto mesh = geometry.child("mesh");
  return mesh ? mesh : geometry.child("convex_mesh");
}

}  // namespace

std::vector<Vec3> read_vertices(const XmlElement& geometry, ColladaDocument& document) {
  const auto mesh = mesh_of(geometry);
  const auto vertices = mesh ? mesh->child("vertices") : std::nullopt;
  if (!vertices) geometry.fail("this <geometry> has no <vertices>, which a controller needs");
  std::vector<Vec3> result;
  for (const XmlElement& input : vertices->children("input")) {
    if (input.attribute("semantic") != "POSITION") continue;
    const SourceValues values = read_source(document.resolve(input, "source", "source"), 3, document);
    for (std::size_t i = 0; i < values.count(); ++i) result.push_back(values.vec3(i));
    break;
  }
  return result;
}

void warn_where_empty(const XmlElement& geometry, const ColladaGeometry& read, ColladaDocument& document) {
  const auto mesh = mesh_of(geometry);
  if (mesh && read.parts.empty())
    document.warn(*mesh, fmt::format("this <{}> has no triangles or polygons", mesh->name()));
}

ColladaGeometry read_geometry(const XmlElement& geometry, ColladaDocument& document) {
  ColladaGeometry result;
  const auto technique = cgl_technique(geometry);
  const auto sphere = technique ? technique->child("sphere") : std::nullopt;
  const auto mesh = mesh_of(geometry);
  if (sphere && mesh)
    document.warn(*sphere, "a geometry with a <mesh> cannot be a sphere too; the sphere is left out");
  if (mesh) {
    ColladaSources sources(document);
    for (const XmlElement& element : parts_of(*mesh, document))
      result.parts.push_back(read_part(element, display_name(geometry), document, sources));
  } else if (sphere) {
    result.sphere_radius = float(number_in(sphere->required_child("radius"), 0, max_coordinate));
  } else {
    document.warn(geometry, "this <geometry> has no <mesh> and is no CGL <sphere>; it is left out");
  }
  return result;
}

}  // namespace twinray
