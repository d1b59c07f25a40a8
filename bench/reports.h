// SPDX-License-Identifier: Apache-2.0
// Results as text.
#pragma once
#include <string>

#include "bench/results.h"

namespace twinray::bench {

/// A table for people: speeds against the baseline, one line for each scene and engine.
std::string text_report(const SceneStatistics& scene);
/// One line: how fast a scene file is read.
std::string text_report(const ReadingStatistics& reading);
/// The same for whole pictures.
std::string text_report(const PictureOfScene& picture);
/// Everything, every round.
std::string json_report(const Results& results);
/// One line for each scene, engine and ray set, and one ("all") for the geometric mean over the sets.
std::string csv_report(const Results& results);
/// One page that needs nothing else: tables and plots, with their spreads.
std::string html_report(const Results& results);

}  // namespace twinray::bench
