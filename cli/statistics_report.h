// SPDX-License-Identifier: Apache-2.0
// What a build and its rays took, as text and as JSON: the same words and keys in all commands
// (docs/statistics.md). What an engine does not know is not said: a dash in a table, null in JSON.
#pragma once
#include <string>

#include "accel/accelerator.h"
#include "cli/denoising.h"
#include "cli/render_arguments.h"
#include "cli/stats/arguments.h"
#include "cli/stats/engine_statistics.h"
#include "integrators/render.h"

namespace twinray {

/// The statistics at the end of a render, as lines of text: those that CS184's program prints, and rays by
/// kind; counts if it was to count.
std::string statistics_text(const RenderArguments& arguments, const AccelStats& accel,
                            const RenderResult& result);

/// What was done with a picture besides rendering it.
struct FurtherStatistics {
  std::string check = "";                     ///< Itself a JSON text; empty: none.
  const DenoisedPicture* denoised = nullptr;  ///< Null: it is not denoised.
};

/// All statistics of a render as a JSON text; further ones as members "check" and "denoising".
std::string statistics_json(const RenderArguments& arguments, const AccelStats& accel,
                            const RenderResult& result, const FurtherStatistics& further = {});

/// Says which tiles of textures could not be read; empty if all could.
std::string unread_tiles_text(const RenderArguments& arguments);

/// Says how to see a rejected sample again; empty if there was none.
std::string rejection_text(const Film& film, const RenderArguments& arguments);

/// One line an engine, and what the statistics were measured with; "-" stands for what an engine does not
/// know.
std::string stats_text(const StatsArguments& arguments, const SceneStatistics& statistics);

/// One line for each engine and kind of rays, after a line of names; what is not known is left empty.
std::string stats_csv(const SceneStatistics& statistics);

/// The same as JSON; what is not known is null.
std::string stats_json(const StatsArguments& arguments, const SceneStatistics& statistics);

}  // namespace twinray
