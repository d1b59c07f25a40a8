// SPDX-License-Identifier: Apache-2.0
// Triangle meshes from PLY files (Greg Turk, "The PLY Polygon File Format", 1994): ASCII and binary of both
// byte orders. Properties and elements of any kind may stand in the file; what a mesh has no use for is
// skipped.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/geometry.h"
#include "core/rgb.h"

namespace twinray {

/// What a PLY file holds of a mesh.
struct PlyMesh {
  /// Normals, if the vertices have nx, ny, nz: of the file's length, which may be 0. Texture coordinates, if
  /// they have u and v, s and t, or texture_u and the like; second ones, if they have u2 and v2. Faces of
  /// four corners are cut in two, those of more into as many as it takes, with their winding.
  Mesh mesh;
  std::size_t flat_faces = 0;  ///< Faces of less than three corners: left out.
  /// Colours of the vertices, if they have red, green and blue (or diffuse_red and the like, or r, g, b) and
  /// were asked for: linear, in [0, 1].
  std::vector<Rgb> colors = {};
  std::size_t quads = 0;  ///< Faces of four corners that are two triangles, both with an area.
  std::vector<std::string> left_out = {};  ///< What the file has and is not read, in words.
};

/// Whether the colours of vertices are read.
enum class PlyColors { skip, read };

/// Reads the bytes of a file; `name` stands for it in messages, and for the mesh. Throws Error, with the
/// place or the byte, where it is no PLY file, is cut off, has an index out of range or a position that is
/// not finite. Nothing is allocated for counts that the file is too short for.
PlyMesh read_ply(std::string_view bytes, const std::string& name, PlyColors colors = PlyColors::skip);

}  // namespace twinray
