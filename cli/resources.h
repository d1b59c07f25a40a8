// SPDX-License-Identifier: Apache-2.0
// What a command needs of the machine, asked before it begins.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "accel/accelerator.h"
#include "check/recorded_rays.h"
#include "cli/render_arguments.h"
#include "core/memory.h"
#include "integrators/render.h"

namespace twinray {

/// The film, and the pictures that are made of it; without the scene, but for its light groups.
std::vector<MemoryNeed> memory_needs(const RenderOptions& options, const Scene& scene = {});

/// The engine's tree over so many primitives, at the worst moment of its building; an estimate. Nothing for
/// an engine without a tree.
std::vector<MemoryNeed> memory_needs(Backend backend, const BuildOptions& build, std::size_t primitives);

/// Film, pictures and trees: what is still to be made for a render once its scene is there.
std::vector<MemoryNeed> memory_needs(const RenderArguments& arguments, const Scene& scene);

/// The rays of a picture, at most, each held twice: all together, and by kind.
std::vector<MemoryNeed> memory_needs(const Recording& recording);

/// That fewer threads can be made than are wanted (0: as many as the machine has); empty where all can.
std::string thread_warning(int wanted);

}  // namespace twinray
