// SPDX-License-Identifier: Apache-2.0
#include "cli/shell_text.h"

#include <string_view>
#include <utility>

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

Words words_of(const std::string& shell_text) {
  Words words;
  bool is_within_word = false, is_quoted = false;
  for (std::size_t i = 0; i < shell_text.size(); ++i) {
    const char c = shell_text[i];
    if (c == ' ' && !is_quoted) {
      is_within_word = false;
      continue;
    }
    if (!std::exchange(is_within_word, true)) words.emplace_back();
    if (c == '\'')
      is_quoted = !is_quoted;
    else if (c == '\\' && !is_quoted && i + 1 < shell_text.size())
      words.back() += shell_text[++i];
    else
      words.back() += c;
  }
  return words;
}

}  // namespace twinray
