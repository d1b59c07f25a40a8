// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/light.h"
#include "core/scene.h"
#include "io/losses.h"

namespace twinray {

/// For formats in which fronts alone emit: a mesh whose back does is turned around. Names what changes then,
/// if its material's outside is not like its inside.
void name_turned_emitter(const Scene& scene, const MeshLight& light, Losses& losses);

}  // namespace twinray
