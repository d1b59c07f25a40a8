// SPDX-License-Identifier: Apache-2.0
// How joints move the vertices of a skin (linear blend skinning: Magnenat-Thalmann, Laperriere, Thalmann,
// "Joint-Dependent Local Deformations", 1988): a vertex goes where its joints take it, weighted.
#pragma once
#include <vector>

#include "core/transform.h"
#include "io/collada/joints.h"

namespace twinray {

/// Of a <skin>: the geometry's coordinates to those in which its joints were bound to it.
Transform bind_shape(const XmlElement& skin, ColladaDocument& document);

/// For each of so many vertices of the geometry at the end of a skin's sources, what brings it to the scene:
/// the sum of weight * joint * inverse bind matrix * bind shape, over the sum of its weights. A joint of -1
/// is the bind shape itself; so a vertex stands that has no weight. Throws PlacedError where a joint is
/// missing, where numbers do not fit together, and for what reading them throws.
std::vector<Transform> skin_transforms(const XmlElement& skin, const XmlElement& instance,
                                       std::size_t vertices, const ColladaJoints& joints,
                                       ColladaDocument& document);

}  // namespace twinray
