// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "core/geometry.h"

namespace twinray {

/// The bytes of a binary little-endian PLY file of the mesh: its triangles in their order, each number with
/// all its bits. A vertex has one position, one normal and one place in each set of texture coordinates there
/// (u and v, u2 and v2): a position that triangles use with several normals or coordinates becomes several
/// vertices, in the order of their first use.
std::string ply_bytes(const Mesh& mesh);

}  // namespace twinray
