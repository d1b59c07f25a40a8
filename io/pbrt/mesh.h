// SPDX-License-Identifier: Apache-2.0
// The shapes that are lists of vertices and indices: their parameters, checked.
#pragma once
#include "core/geometry.h"
#include "io/pbrt/context.h"
#include "io/pbrt/parameters.h"
#include "io/ply/reader.h"

namespace twinray {

/// Numbers in threes.
std::vector<Vec3> triples(std::span<const float> numbers);

// Each gives a mesh without indices of normals and uvs: they are those of the positions. Throws Error where
// positions are missing or not enough, or an index is out of range.

Mesh read_triangle_mesh(const PbrtParameters& parameters, WarningList& warnings);
/// Patches without texture coordinates have their parameters.
Mesh read_bilinear_mesh(const PbrtParameters& parameters, WarningList& warnings);
/// A subdivision surface's triangles with its normals; its control mesh, with a warning, where it is none.
/// Throws Error, too, where they would be too many.
Mesh read_loop_mesh(const PbrtParameters& parameters, WarningList& warnings);

/// The mesh in the file that a plymesh names.
PlyMesh read_ply_file(const PbrtParameters& parameters, PbrtContext& context);

}  // namespace twinray
