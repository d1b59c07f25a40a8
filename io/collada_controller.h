// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/transform.h"
#include "io/collada_document.h"

namespace twinray {

/// What a <controller> moves, as it is before that: the geometry at the end of its chain of sources.
struct ControlledGeometry {
  XmlElement geometry;
  Transform bind_shape;  ///< Of a skin: the geometry's coordinates to those of the node. Else the identity.
};

/// Follows a <controller>'s chain of sources to its geometry, with a warning for each of its controllers: a
/// skin's joints do not pose it, and a morph's targets do not change it. Throws Error for a chain that forms
/// a circle, or leads nowhere.
ControlledGeometry controlled_geometry(const XmlElement& controller, ColladaDocument& document);

}  // namespace twinray
