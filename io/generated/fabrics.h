// SPDX-License-Identifier: Apache-2.0
// What hangs and lies in the room; each of any number of triangles.
#pragma once
#include "io/generated/scene_maker.h"

namespace twinray::generated {

/// A cloth draped over the table: a fine grid of nearly square cells. A few triangles fewer than asked for.
void add_tablecloth(SceneMaker& scene, std::size_t triangles);
/// Four curtains beside the windows, of few rows and many columns: triangles as long as a forearm and a
/// millimetre wide. A few fewer than asked for.
void add_curtains(SceneMaker& scene, std::size_t triangles);
/// A shaggy rug before the sofa: as many blades, of one triangle each.
void add_rug(SceneMaker& scene, std::size_t triangles);

}  // namespace twinray::generated
