// SPDX-License-Identifier: Apache-2.0
// The mark that some editors write in front of UTF-8.
#pragma once
#include <cstddef>
#include <string_view>

namespace twinray {

/// How many bytes it has, 3, if the text begins with it; else 0.
inline std::size_t mark_size(std::string_view text) {
  constexpr std::string_view mark = "\xef\xbb\xbf";
  return text.starts_with(mark) ? mark.size() : 0;
}

/// The text without it.
inline std::string_view without_mark(std::string_view text) { return text.substr(mark_size(text)); }

}  // namespace twinray
