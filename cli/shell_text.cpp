// SPDX-License-Identifier: Apache-2.0
#include "cli/shell_text.h"

#include <string_view>

namespace twinray {

std::string shell_text(const Words& words) {
  std::string text;
  for (const std::string& word : words) {
    constexpr std::string_view plain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._/=,:+@%-";
    if (!text.empty()) text += ' ';
    if (!word.empty() && word.find_first_not_of(plain) == word.npos) {
      text += word;
      continue;
    }
    text += '\'';
    for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    text += '\'';
  }
  return text;
}

}  // namespace twinray
