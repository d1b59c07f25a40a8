// SPDX-License-Identifier: Apache-2.0
// Where markup starts and ends in an XML text. Offsets beyond the end stand at the end; nothing is ever
// invalid.
#pragma once
#include <algorithm>
#include <cstddef>
#include <string_view>

namespace twinray {

inline bool starts_at(std::string_view text, std::size_t i, std::string_view what) {
  return text.substr(i, what.size()) == what;
}

/// The offset behind the next `what`; the end of the text where there is none.
inline std::size_t behind(std::string_view text, std::size_t from, std::string_view what) {
  const std::size_t found = text.find(what, from);
  return found == std::string_view::npos ? text.size() : found + what.size();
}

/// The offset behind the '>' that ends the tag at `i`; a '>' within quotes does not.
inline std::size_t behind_tag(std::string_view text, std::size_t i) {
  while (i < text.size() && text[i] != '>') {
    if (text[i] == '"' || text[i] == '\'') i = std::min(text.find(text[i], i + 1), text.size());
    if (i < text.size()) ++i;
  }
  return std::min(i + 1, text.size());
}

/// Whether the '<' at `i` starts a tag that opens an element.
inline bool is_start_tag(std::string_view text, std::size_t i) {
  const char next = i + 1 < text.size() ? text[i + 1] : '\0';
  return next != '?' && next != '!' && next != '/';
}

/// The offset behind the tag, comment, CDATA section, declaration or instruction whose '<' stands at `i`.
inline std::size_t behind_markup(std::string_view text, std::size_t i) {
  if (i >= text.size()) return text.size();
  if (starts_at(text, i, "<?")) return behind(text, i, "?>");
  if (starts_at(text, i, "<!--")) return behind(text, i, "-->");
  if (starts_at(text, i, "<![CDATA[")) return behind(text, i, "]]>");
  return is_start_tag(text, i) ? behind_tag(text, i) : behind(text, i, ">");
}

/// The offset of the next start tag's '<' at or after `i`; npos where there is none.
inline std::size_t next_start_tag(std::string_view text, std::size_t i) {
  while ((i = text.find('<', i)) != std::string_view::npos && !is_start_tag(text, i))
    i = behind_markup(text, i);
  return i;
}

}  // namespace twinray
