// SPDX-License-Identifier: Apache-2.0
// One lamp, once. CS184's boxes describe their lamp twice: as an area light, and as an emissive mesh in the
// same place. Both together would shine twice, and shade each other. So where the two coincide the mesh is
// the lamp, with the area light's color and side, and the rectangle is left out.
#pragma once
#include "io/collada/parts.h"

namespace twinray {

/// Applies the rule, and notes each case.
///
/// An area light coincides with an emissive mesh if all of the mesh lies within 10^-3 of the rectangle's
/// longer side of its plane, their centres within 1 % of it, and the sides of the mesh's box agree with those
/// of the rectangle, in either order, within 1 % (CS184's are swapped). All triangles of the mesh must face
/// the same way. A point light within the same distance of the plane, and within the outline, of an emissive
/// mesh of that kind coincides with it too (CBempty.dae): there the mesh keeps its own color.
void merge_lamps(SceneParts& parts);

/// Whether it would leave out a light.
bool has_double_lamps(const SceneParts& parts);

}  // namespace twinray
