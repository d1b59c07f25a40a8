// SPDX-License-Identifier: Apache-2.0
// From the words of a command line to what they ask for.
#pragma once
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "cli/options/options.h"
#include "cli/render_arguments.h"

namespace twinray {

/// Adds a render's options. The function that is returned gives what they ask for, once they are read; it
/// throws UsageError with the reason where they contradict each other, or, if it is to be strict, where one
/// has no effect. The app must outlive the reading.
std::function<RenderArguments()> add_render_options(CLI::App& app);

/// Throws UsageError with the first of the options without effect where these are errors.
void refuse_if_strict(const std::vector<std::string>& without_effect, const RenderArguments& arguments);

/// The long names of options, and their words.
using RenderWords = std::map<std::string, Words>;
/// Those of the words after "render" that are not their options' defaults, whatever they mean together.
/// Throws UsageError.
RenderWords parse_render_words(const Words& words);

/// Reads the words after "render". Throws UsageError.
RenderArguments parse_render_arguments(const std::vector<std::string>& words);

}  // namespace twinray
