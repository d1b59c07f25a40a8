// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "cli/options/options.h"

namespace twinray {

/// A command as a shell takes it: words with other characters than those of plain names in quotes.
std::string shell_text(const Words& words);
/// The words of such a text.
Words words_of(const std::string& shell_text);

}  // namespace twinray
