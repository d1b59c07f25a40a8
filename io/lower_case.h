// SPDX-License-Identifier: Apache-2.0
// Private: words whose capitals mean nothing.
#pragma once
#include <algorithm>
#include <string>

namespace twinray {

/// The text with small letters for ASCII's capitals; other bytes stay.
inline std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
  return text;
}

}  // namespace twinray
