// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "cli/film/film_notes.h"
#include "cli/render_arguments.h"

namespace twinray {

/// What decides about the samples of a render that reads these files. What changes none is left out: words
/// that are their options' defaults, path-reference, which is path, engines but where the picture
/// depends on them, threads, outputs, how many samples.
RenderIdentity render_identity(const RenderArguments& arguments, const InputFiles& inputs);

}  // namespace twinray
