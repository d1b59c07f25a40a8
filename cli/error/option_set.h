// SPDX-License-Identifier: Apache-2.0
// Render options with a name, as one word of a command line: "calm: --roulette=1 --sampler=independent".
#pragma once
#include <string>

#include "cli/options/options.h"
#include "cli/options/render.h"

namespace twinray::error {

/// A way to render that is compared with others.
struct OptionSet {
  std::string name;
  Words options;  ///< Beside those of all sets.
  RenderArguments arguments;
};

/// The name before the first colon and the options behind it; a text of options alone is its own name. Throws
/// UsageError for a text without a name or with a quote that is not closed.
OptionSet parse_option_set(const std::string& text);

/// Splits at spaces; within '...' or "..." a space belongs to a word. Throws UsageError for a quote that is
/// not closed.
Words split_words(const std::string& text);

/// Reads the options of a set into its arguments, after those that all sets have: options of light, sampling
/// and engine. Throws UsageError, in the set's name.
void read_options(const RenderRequest& common, const Words& given, OptionSet& set);

}  // namespace twinray::error
