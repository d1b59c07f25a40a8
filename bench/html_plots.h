// SPDX-License-Identifier: Apache-2.0
// The plots of the page, from the results.
#pragma once
#include <string>

#include "bench/results.h"

namespace twinray::bench {

/// Bars of every engine's speed on every scene, and below one plot of dots for each ray set.
std::string speed_plots(const Results& results);
/// The time of a ray over the number of triangles, one plot for each family of generated scenes.
std::string growth_plots(const Results& results);
/// Speed over build time, both against the baseline: one dot for each engine and scene.
std::string build_plot(const Results& results);

/// Whole pictures: a table, the error over time, and what threads give. Empty where none were rendered.
std::string whole_section(const Results& results);

/// How fast scene files are read, a table; empty where none was.
std::string reading_section(const Results& results);

}  // namespace twinray::bench
