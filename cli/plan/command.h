// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <optional>
#include <string>

#include "cli/plan/farm_plan.h"
#include "cli/render_arguments.h"

namespace twinray {

/// What a plan's command line asks for.
struct PlanArguments {
  RenderArguments render;  ///< Of the first frame.
  std::string folder;
  std::optional<std::uint32_t> jobs;   ///< Parts of each frame,
  std::optional<double> part_minutes;  ///< or how long a part is to take on this machine.
  std::optional<FrameRange> frames;
  bool by_tiles = false;  ///< Parts are ranges of tiles, also where they could be ranges of samples.
};

/// The words as the first of their --frames has them, with its number in their places for it: what is a
/// number in a frame need not be one in the plan's words.
Words words_of_first_frame(const Words& words);

/// Adds the options, and those of a render's first frame; the function that is returned gives what they ask
/// for. It throws UsageError.
std::function<PlanArguments()> add_plan_options(CLI::App& app);

/// twinray plan SCENE --folder=DIR [options of a render]: divides a picture, or the frames of a shot, into
/// parts, and writes what job engines need to render and merge them. `words` are those of the command line,
/// `program` how it was called. Returns the exit code. Throws Error.
int plan_command(const PlanArguments& arguments, const Words& words);

}  // namespace twinray
