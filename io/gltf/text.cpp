// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string_view>

#include "io/gltf/context.h"

namespace twinray {
namespace {

/// Gives each character that stands outside of strings to take(index, character).
template <typename Take>
void scan(const std::string& text, const Take& take) {
  bool is_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (is_string && c == '\\')
      ++i;
    else if (c == '"')
      is_string = !is_string;
    else if (!is_string)
      take(i, c);
  }
}

/// What a file may nest; the format itself needs less than ten levels, what tools add may have more.
constexpr int most_depth = 100;

/// An exponent below 0 leads to 0 where no double is as small.
bool is_too_large(std::string_view number) {
  double value = 0;
  return std::from_chars(number.data(), number.data() + number.size(), value).ec ==
             std::errc::result_out_of_range &&
         number.find("e-") == std::string_view::npos && number.find("E-") == std::string_view::npos;
}

}  // namespace

void check_depth(const std::string& text, const GltfContext& context) {
  int depth = 0;
  scan(text, [&](std::size_t i, char c) {
    if (c == '{' || c == '[') ++depth;
    if (c == '}' || c == ']') --depth;
    if (depth > most_depth)
      throw error_at(place_of(context.file, text, i),
                     fmt::format("objects and arrays nest deeper than {} levels", most_depth));
  });
}

std::size_t too_large_number(const std::string& text) {
  std::size_t found = text.size(), end = 0;
  scan(text, [&](std::size_t i, char c) {
    const bool begins = c == '-' || (c >= '0' && c <= '9');
    if (!begins || i < end || found < text.size()) return;
    end = std::min(text.find_first_not_of("+-.0123456789Ee", i), text.size());
    if (is_too_large(std::string_view(text).substr(i, end - i))) found = i;
  });
  return found;
}

}  // namespace twinray
