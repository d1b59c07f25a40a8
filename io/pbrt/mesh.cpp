// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/mesh.h"

#include <fmt/format.h>

#include "core/loop_subdivision.h"
#include "io/pbrt/quadric.h"
#include "io/ply/reader.h"

namespace twinray {

std::vector<Vec3> triples(std::span<const float> numbers) {
  std::vector<Vec3> list;
  list.reserve(numbers.size() / 3);
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
    list.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
  return list;
}

namespace {

std::vector<Vec2> pairs(std::span<const float> numbers) {
  std::vector<Vec2> list;
  list.reserve(numbers.size() / 2);
  for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) list.push_back({numbers[i], numbers[i + 1]});
  return list;
}

/// Leaves out a list that has not one value for each position.
template <typename Value>
void check_length(std::vector<Value>& values, std::size_t positions, const char* name,
                  const PbrtParameters& parameters, WarningList& warnings) {
  if (values.empty() || values.size() == positions) return;
  parameters.find(name)->place.warn(
      warnings,
      fmt::format("\"{}\" has {} values for {} positions; it is left out", name, values.size(), positions));
  values.clear();
}

Mesh read_vertices(const PbrtParameters& parameters, WarningList& warnings) {
  Mesh mesh;
  mesh.positions = triples(parameters.tuples("P", 3));
  if (mesh.positions.empty()) parameters.place().fail("this shape needs its positions, \"point3 P\"");
  mesh.normals = triples(parameters.tuples("N", 3));
  mesh.uvs = pairs(parameters.tuples("uv", 2));
  parameters.find("faceIndices");  // Nothing rendered needs them.
  if (const PbrtParameter* tangents = parameters.find("S"))
    tangents->place.warn(warnings,
                         "tangents are not rendered: those of the texture coordinates stand for them");
  check_length(mesh.normals, mesh.positions.size(), "N", parameters, warnings);
  check_length(mesh.uvs, mesh.positions.size(), "uv", parameters, warnings);
  return mesh;
}

/// Indices in groups of `corners`, checked; the first group of positions where there are just as many.
std::vector<std::uint32_t> read_indices(const PbrtParameters& parameters, const Mesh& mesh,
                                        std::size_t corners) {
  const std::span<const std::int32_t> given = parameters.integers("indices");
  std::vector<std::uint32_t> indices(given.begin(), given.end());
  if (given.empty() && mesh.positions.size() == corners)
    for (std::uint32_t i = 0; i < corners; ++i) indices.push_back(i);
  if (indices.empty())
    parameters.place().fail(fmt::format("this shape of {} positions needs \"integer indices\", {} a face",
                                        mesh.positions.size(), corners));
  if (indices.size() % corners != 0)
    parameters.find("indices")->place.fail(
        fmt::format("{} indices are not {} a face", indices.size(), corners));
  for (std::size_t i = 0; i < indices.size(); ++i)
    if (indices[i] >= mesh.positions.size())
      parameters.find("indices")->place.fail(
          fmt::format("the index {} (number {}) is out of range; valid are 0 to {}", std::int32_t(indices[i]),
                      i + 1, mesh.positions.size() - 1));
  return indices;
}

}  // namespace

Mesh read_triangle_mesh(const PbrtParameters& parameters, WarningList& warnings) {
  Mesh mesh = read_vertices(parameters, warnings);
  const std::vector<std::uint32_t> indices = read_indices(parameters, mesh, 3);
  mesh.triangles.reserve(indices.size() / 3);
  for (std::size_t i = 0; i < indices.size(); i += 3)
    mesh.triangles.push_back({indices[i], indices[i + 1], indices[i + 2]});
  return mesh;
}

namespace {

/// Gives each patch corners of its own, with its parameters as texture coordinates: pbrt's are these.
void add_parameters(std::vector<std::uint32_t>& indices, Mesh& mesh) {
  const std::vector<Vec3> positions = std::move(mesh.positions), normals = std::move(mesh.normals);
  mesh.positions.clear(), mesh.normals.clear();
  for (std::uint32_t i = 0; i < indices.size(); ++i) {
    mesh.positions.push_back(positions[indices[i]]);
    if (!normals.empty()) mesh.normals.push_back(normals[indices[i]]);
    mesh.uvs.push_back({float(i % 2), float(i / 2 % 2)});
    indices[i] = i;
  }
}

}  // namespace

Mesh read_bilinear_mesh(const PbrtParameters& parameters, WarningList& warnings) {
  Mesh mesh = read_vertices(parameters, warnings);
  parameters.find("emissionfilename");  // About sampling: the light's own picture is what it emits.
  std::vector<std::uint32_t> indices = read_indices(parameters, mesh, 4);
  if (mesh.uvs.empty()) add_parameters(indices, mesh);
  for (std::size_t i = 0; i < indices.size(); i += 4)
    add_bilinear_patch({indices[i], indices[i + 1], indices[i + 2], indices[i + 3]}, mesh);
  return mesh;
}

Mesh read_loop_mesh(const PbrtParameters& parameters, WarningList& warnings) {
  constexpr double most_triangles = 1 << 24;  // They take 2 GB for a moment.
  constexpr std::int32_t usual_levels = 3;
  parameters.find("scheme");  // There is one.
  const std::int32_t levels = parameters.integer("levels", usual_levels, {0, most_loop_levels});
  const Mesh control = read_triangle_mesh(parameters, warnings);
  if (const double triangles = loop_triangles(control.triangles.size(), levels); triangles > most_triangles)
    parameters.place().fail(fmt::format("{} levels of {} triangles make {:.0f}; at most {:.0f} are valid",
                                        levels, control.triangles.size(), triangles, most_triangles));
  if (auto divided = loop_subdivided(control, levels)) {
    // pbrt's point to where the control mesh's corners appear clockwise, and say what is outside.
    for (Vec3& normal : divided->normals) normal = -normal;
    return std::move(*divided);
  }
  parameters.place().warn(
      warnings,
      "this control mesh is no surface (more than two triangles at an edge, two windings, or "
      "triangles that share a corner alone): it is shown as it is");
  return control;
}

PlyMesh read_ply_file(const PbrtParameters& parameters, PbrtContext& context) {
  const std::string name = parameters.text("filename", "");
  if (name.empty()) parameters.place().fail("a plymesh needs its file, \"string filename\"");
  if (const PbrtParameter* displacement = parameters.find("displacement"))
    displacement->place.warn(context.warnings, "displacement is not rendered: the mesh stays as it is");
  parameters.find("edgelength");  // of displacement
  const PbrtPlace& place = parameters.find("filename")->place;
  const std::string path = context.files.path(place, name);
  const std::string bytes = context.files.bytes(place, path);
  try {
    PlyMesh ply = read_ply(bytes, path);
    if (ply.flat_faces > 0)
      place.warn(context.warnings, fmt::format("{}: {} faces have less than three corners, and are left out",
                                               path, ply.flat_faces));
    return ply;
  } catch (const Error& error) {
    place.fail(error.what());
  }
}

}  // namespace twinray
