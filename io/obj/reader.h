// SPDX-License-Identifier: Apache-2.0
// Private: Wavefront OBJ and MTL files as they stand, read by tinyobjloader.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <tiny_obj_loader.h>

#include "core/rgb.h"
#include "core/vec.h"
#include "io/diagnostic.h"

namespace twinray {

/// What a corner of a face has none of.
inline constexpr std::uint32_t no_element = 0xffffffff;

/// A corner of a face: indices into the model's vectors.
struct ObjCorner {
  std::uint32_t position = 0, normal = no_element, uv = no_element;
};

/// Faces of one object, group and material, all or none of whose corners have normals, and texture
/// coordinates.
struct ObjFaces {
  std::string object;  ///< "" outside of all.
  std::string group;   ///< "" outside of all.
  int material = -1;   ///< Index into the model's materials; -1: it has none.
  bool has_normals = false, has_uvs = false;
  std::vector<ObjCorner> corners;    ///< Face by face.
  std::vector<std::uint32_t> sizes;  ///< How many of them each face has: 3 to max_polygon_corners.
};

struct ObjModel {
  std::string name;  ///< The file's, without folder and extension.
  std::vector<Vec3> positions, normals;
  std::vector<Rgb> colors;  ///< Of the positions, linear, white where there are none; or none at all.
  std::vector<Vec2> uvs;
  std::vector<ObjFaces> faces;
  std::vector<tinyobj::material_t> materials;
  std::vector<std::string> material_files;  ///< Of each material.
  std::size_t small_faces = 0;              ///< Faces of less than three corners: left out.
  bool has_weights = false;                 ///< Behind the coordinates of vertices: left out.
  std::vector<std::string> notes;           ///< Of what else is left out or guessed.
};

/// The bytes of the file of a name, or an Error.
using ReadFile = std::function<std::string(const std::string& path)>;

/// Reads a file, and the material files that it names. Throws Error, with the place, where a face has a
/// vertex that there is not or too many corners, or a vertex not three numbers, and for a file without faces.
/// What is wrong with normals, texture coordinates and materials is a warning.
ObjModel read_obj(const std::string& path, const ReadFile& read, WarningList& warnings);

}  // namespace twinray
