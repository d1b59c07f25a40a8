// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>
#include <vector>

#include "cli/live/picture_viewer.h"
#include "cli/render_arguments.h"
#include "cli/render_outputs.h"

namespace twinray {

/// Those who may look at the picture of a render, as its options ask for; says on standard error where the
/// page is. `partial` has what is kept of a render that is stopped. Throws Error where a server cannot
/// listen.
std::vector<std::unique_ptr<PictureViewer>> picture_viewers(const RenderArguments& arguments,
                                                            const RenderOutputs& outputs,
                                                            const RenderOutputs& partial);

}  // namespace twinray
