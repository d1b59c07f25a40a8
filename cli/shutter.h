// SPDX-License-Identifier: Apache-2.0
// --time with two times: while the shutter is open.
#pragma once
#include <cstdint>
#include <optional>

#include "cli/render_arguments.h"
#include "io/loaded_scene.h"

namespace twinray {

/// Throws UsageError where a shutter is asked for, and something that does not go with it.
void check_shutter(const RenderArguments& arguments);

/// When what moves in a scene is seen, which the file may say. Warns where the file does, and an option does
/// not go with that. None where nothing moves.
std::optional<Shutter> shutter_of(const RenderArguments& arguments, const LoadedScene& loaded);

/// How many samples of a pixel see the same moment where nobody says it: 1 of a scene that is soon read and
/// built again, 4 of a larger one.
std::uint32_t usual_samples_per_moment(const Geometry& geometry);

}  // namespace twinray
