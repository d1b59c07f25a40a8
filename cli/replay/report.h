// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "cli/replay/sample.h"

namespace twinray {

/// All of replay_text() as JSON. Floats keep their bits; those that are not finite are the strings "inf",
/// "-inf" and "nan". docs/replay.md describes it.
std::string replay_json(const ReplayedSample& replayed);

}  // namespace twinray
