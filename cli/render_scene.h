// SPDX-License-Identifier: Apache-2.0
// What a render begins with: the scene as its options want it, and the estimator of its light.
#pragma once
#include <memory>

#include "cli/render_arguments.h"
#include "cli/render_talk.h"
#include "integrators/integrator.h"
#include "io/scene_file.h"

namespace twinray {

/// The scene with the camera, the lens, the environment and the light that the options ask for; prints what
/// is to be warned of. What the file says about its picture becomes an argument where no option was given.
/// Throws Error, and UsageError where options without effect are errors.
LoadedScene load_for_render(RenderArguments& arguments, RenderTalk& talk);

/// The same scene at another time, silently: `first` is what load_for_render has made of it. A camera that is
/// not the file's stays where it is.
LoadedScene load_for_moment(const RenderArguments& arguments, const LoadedScene& first, double time);

/// The scene must outlive it.
std::unique_ptr<Integrator> make_integrator(const RenderArguments& arguments, const Scene& scene);

}  // namespace twinray
