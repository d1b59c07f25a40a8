// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "cli/replay/sample.h"

namespace twinray {

/// "diffuse reflection", "glossy reflection", "mirror reflection", "rough transmission", "smooth
/// transmission": the last and the mirror's in one direction alone; or "scattering in a medium".
std::string event_name(const Interaction& at, const Scattering& next);
/// Why the path has no further vertex, as a clause: "the ray leaves the scene".
std::string end_text(PathEnd end);

/// The path in words: every vertex, what each way of finding light brought there, and the sum. Floats have as
/// many digits as tell them from all others.
std::string replay_text(const ReplayedSample& replayed);

}  // namespace twinray
