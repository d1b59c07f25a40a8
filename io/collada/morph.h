// SPDX-License-Identifier: Apache-2.0
// How a morph blends the vertices of its base with those of its targets, each with a weight w:
// NORMALIZED (1 - sum w) base + sum w target, RELATIVE base + sum w target.
#pragma once
#include <vector>

#include "core/vec.h"
#include "io/collada/document.h"
#include "io/collada/geometry.h"

namespace twinray {

struct MorphTarget {
  XmlElement element;  ///< A <geometry> or a <controller>.
  float weight = 0;
};

struct MorphTargets {
  std::vector<MorphTarget> targets;
  float base_weight = 1;
};

/// Throws PlacedError where targets or weights are missing.
MorphTargets read_morph_targets(const XmlElement& morph, ColladaDocument& document);

/// Vertices, as the file numbers them, and what they are the corners of.
struct ControlledShape {
  std::vector<Vec3> vertices;
  ColladaGeometry geometry;
};

/// Multiplies vertices and normals.
void scale(ControlledShape& shape, float weight);

/// Adds those of a target, of which there must be as many vertices. A part's normals are added where the
/// target's corners use theirs alike; else the part loses its normals, and shades flat.
void add_scaled(ControlledShape& shape, const ControlledShape& target, float weight);

}  // namespace twinray
