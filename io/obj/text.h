// SPDX-License-Identifier: Apache-2.0
// Private: lines of OBJ and MTL files, and the words and numbers in them.
#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace twinray {

/// Whether a line goes on behind a backslash at its end; a comment does not.
bool has_continued_lines(std::string_view text);
/// The text with such lines as one: the backslash and the end of the line are spaces, so that all else stays
/// where it is.
std::string joined_lines(std::string text);

/// Takes the first word off a line; "" where only a comment or nothing is left.
std::string_view take_word(std::string_view& line);

bool is_number(std::string_view word);

/// The numbers of a line behind its keyword, up to the first word that is none.
struct ObjNumbers {
  std::array<float, 8> values{};  ///< Of more, the first eight. Infinite where one is too large.
  std::size_t count = 0;
  std::string_view end;  ///< The word that is no number; "": the line ends.
};
ObjNumbers read_numbers(std::string_view line);

}  // namespace twinray
