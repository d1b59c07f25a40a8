// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/mesh_area.h"
#include "io/pbrt/curve.h"
#include "io/pbrt/curve_reader.h"
#include "io/pbrt/mesh.h"
#include "io/pbrt/quadric.h"
#include "io/pbrt/transform.h"
#include "io/placed_mesh.h"

namespace twinray {
namespace {

constexpr NumberRange sizes{1e-12, 1e12}, heights{-1e12, 1e12}, angles{0, 360};

std::optional<PbrtShape> read_sphere(const PbrtParameters& parameters, PbrtContext&) {
  PartialSphere sphere;
  sphere.radius = parameters.real("radius", 1, sizes);
  sphere.z_min = parameters.real("zmin", -sphere.radius);
  sphere.z_max = parameters.real("zmax", sphere.radius);
  sphere.phi_max_degrees = parameters.real("phimax", 360, angles);
  const bool is_whole = std::min(sphere.z_min, sphere.z_max) <= -sphere.radius &&
                        std::max(sphere.z_min, sphere.z_max) >= sphere.radius &&
                        sphere.phi_max_degrees >= 360;
  PbrtShape shape;
  if (is_whole)
    shape.sphere_radius = sphere.radius;
  else
    shape.mesh = sphere_mesh(sphere);
  return shape;
}

std::optional<PbrtShape> read_disk(const PbrtParameters& parameters, PbrtContext&) {
  Disk disk;
  disk.height = parameters.real("height", 0, heights);
  disk.radius = parameters.real("radius", 1, sizes);
  disk.inner_radius = parameters.real("innerradius", 0, {0, double(disk.radius)});
  disk.phi_max_degrees = parameters.real("phimax", 360, angles);
  return PbrtShape{disk_mesh(disk)};
}

std::optional<PbrtShape> read_cylinder(const PbrtParameters& parameters, PbrtContext&) {
  const float z0 = parameters.real("zmin", -1, heights), z1 = parameters.real("zmax", 1, heights);
  Cylinder cylinder{parameters.real("radius", 1, sizes), std::min(z0, z1), std::max(z0, z1)};
  cylinder.phi_max_degrees = parameters.real("phimax", 360, angles);
  return PbrtShape{cylinder_mesh(cylinder)};
}

/// What has no area is none of pbrt's shapes that emit.
PbrtShape of_triangles(Mesh mesh) {
  const auto has_area = [&](const Triangle& triangle) { return area_vector(mesh, triangle).area() > 0; };
  const auto pieces = std::count_if(mesh.triangles.begin(), mesh.triangles.end(), has_area);
  return {.mesh = std::move(mesh), .pieces = std::size_t(std::max<std::ptrdiff_t>(pieces, 1))};
}

PbrtShape mesh_shape(Mesh mesh) {
  if (!mesh.normals.empty()) mesh.normal_indices = mesh.triangles;
  if (!mesh.uvs.empty()) mesh.uv_indices = mesh.triangles;
  return of_triangles(std::move(mesh));
}

std::optional<PbrtShape> read_triangles(const PbrtParameters& parameters, PbrtContext& context) {
  return mesh_shape(read_triangle_mesh(parameters, context.warnings));
}

std::optional<PbrtShape> read_bilinear(const PbrtParameters& parameters, PbrtContext& context) {
  PbrtShape shape = mesh_shape(read_bilinear_mesh(parameters, context.warnings));
  shape.pieces = std::max<std::size_t>(parameters.integers("indices").size() / 4, 1);
  return shape;
}

std::optional<PbrtShape> read_ply_mesh(const PbrtParameters& parameters, PbrtContext& context) {
  PlyMesh ply = read_ply_file(parameters, context);
  PbrtShape shape = of_triangles(std::move(ply.mesh));
  shape.pieces -= ply.quads;
  return shape;
}

std::optional<PbrtShape> read_subdivision(const PbrtParameters& parameters, PbrtContext& context) {
  return mesh_shape(read_loop_mesh(parameters, context.warnings));
}

std::optional<PbrtShape> read_curve(const PbrtParameters& parameters, PbrtContext& context) {
  Curve curve = read_curve_points(parameters, context.warnings);
  if (context.has_fibres) curve.kind = CurveKind::cylinder, curve.has_ends = true;
  PbrtShape shape{curve_mesh(curve)};
  const int splits = parameters.integer("splitdepth", 3, {0, 10});
  shape.pieces = segments_of(curve.basis, curve.degree, curve.points.size()) << splits;
  return shape;
}

struct ShapeReader {
  std::string_view type;
  std::optional<PbrtShape> (*read)(const PbrtParameters&, PbrtContext&);
};
constexpr std::array<ShapeReader, 8> shape_readers{{{"trianglemesh", read_triangles},
                                                    {"plymesh", read_ply_mesh},
                                                    {"sphere", read_sphere},
                                                    {"disk", read_disk},
                                                    {"cylinder", read_cylinder},
                                                    {"bilinearmesh", read_bilinear},
                                                    {"loopsubdiv", read_subdivision},
                                                    {"curve", read_curve}}};

void turn(Triangle& triangle) { std::swap(triangle[1], triangle[2]); }

/// The facet's normal, of its area.
Vec3 facet_normal(const Mesh& mesh, const Triangle& t) {
  const Vec3& a = mesh.positions[t[0]];
  return cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a);
}

/// Shading normals that are no directions become their facet's, so that a few bad ones cost nothing.
std::size_t replace_bad_normals(Mesh& mesh) {
  std::size_t count = 0;
  const std::size_t good = mesh.normals.size();
  for (std::size_t i = 0; i < mesh.normal_indices.size(); ++i)
    for (std::uint32_t& index : mesh.normal_indices[i]) {
      if (index >= good || length_squared(mesh.normals[index]) > 0.5f) continue;
      const Vec3 n = facet_normal(mesh, mesh.triangles[i]);
      mesh.normals.push_back(length(n) > 0 ? normalize(n) : Vec3{0, 0, 1});
      index = std::uint32_t(mesh.normals.size() - 1);
      ++count;
    }
  return count;
}

/// Turns the triangles whose shading normals look the other way.
void face_normals(Mesh& mesh) {
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    Vec3 sum;
    for (const std::uint32_t index : mesh.normal_indices[i]) sum += mesh.normals[index];
    if (!(dot(facet_normal(mesh, mesh.triangles[i]), sum) < 0)) continue;
    turn(mesh.triangles[i]);
    turn(mesh.normal_indices[i]);
    if (!mesh.uv_indices.empty()) turn(mesh.uv_indices[i]);
  }
}

Mesh place_mesh(Mesh mesh, const Transform& to_world, bool is_reversed, PlacedShapes& account) {
  for (Vec3& p : mesh.positions) p = to_world.point(p);
  if ((to_world.determinant() < 0) != is_reversed) {
    for (Triangle& triangle : mesh.triangles) turn(triangle);
    for (Triangle& triangle : mesh.normal_indices) turn(triangle);
    for (Triangle& triangle : mesh.uv_indices) turn(triangle);
  }
  account.dropped_triangles += drop_degenerate_triangles(mesh);
  if (mesh.normals.empty()) return mesh;
  turn_normals(mesh, to_world);
  if (is_reversed)
    for (Vec3& normal : mesh.normals) normal = -normal;
  face_normals(mesh);
  account.replaced_normals += replace_bad_normals(mesh);
  return mesh;
}

}  // namespace

std::optional<PbrtShape> read_shape(const std::string& type, const PbrtParameters& parameters,
                                    PbrtContext& context) {
  const auto reader = std::find_if(shape_readers.begin(), shape_readers.end(),
                                   [&](const ShapeReader& r) { return r.type == type; });
  if (reader == shape_readers.end()) {
    std::vector<std::string_view> names;
    for (const ShapeReader& each : shape_readers) names.push_back(each.type);
    parameters.place().fail(fmt::format("there is no shape \"{}\"; valid are {}", type, list_names(names)));
  }
  auto shape = reader->read(parameters, context);
  parameters.find("alpha");  // Of what the shape is made, not where it is: PbrtBuilder reads it.
  parameters.warn_of_unused(context.warnings);
  return shape;
}

Shape place_shape(const PbrtShape& shape, const Transform& to_world, bool is_reversed, bool as_mesh,
                  PlacedShapes& account) {
  const float r = shape.sphere_radius;
  if (!(r > 0)) return place_mesh(shape.mesh, to_world, is_reversed, account);
  const double scale = similarity_scale(to_world);
  if (scale > 0 && !is_reversed && !as_mesh)
    return SphereSet{shape.mesh.name, {{to_world.point({0, 0, 0}), float(scale * double(r))}}};
  Mesh mesh = sphere_mesh({r, -r, r, 360});
  mesh.name = shape.mesh.name;
  return place_mesh(std::move(mesh), to_world, is_reversed, account);
}

}  // namespace twinray
