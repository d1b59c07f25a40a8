// SPDX-License-Identifier: Apache-2.0
// Numbers written in text, separated by white space: each token is a number as a whole, and finite, or an
// error.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace twinray {

/// What is wrong with a list of numbers, and the offset of the token within the text. It never leaves this
/// library: the XML reader makes an Error of it that knows the place.
struct NumberError {
  std::size_t offset;
  std::string message;
};

/// Decimal numbers as XML Schema writes them ("-1.5e3", "+2"); a number too small for the type becomes 0.
/// Throws NumberError for "1,5", "nan", "1e400", "0x10", "1.5f".
std::vector<double> parse_doubles(std::string_view text);
/// The same, each rounded once to float.
std::vector<float> parse_floats(std::string_view text);
/// The same, but what programs write for numbers that are none or infinite ("nan", "-inf", "1.#QNAN") is NaN.
std::vector<float> parse_floats_or_nan(std::string_view text);
/// Indices and counts: whole numbers in [0, 2^32 - 1]. Throws NumberError for anything else.
std::vector<std::uint32_t> parse_indices(std::string_view text);

/// The offset of the token with this index; the text's size where there are not as many.
std::size_t token_offset(std::string_view text, std::size_t index);

/// Text without white space at its ends.
std::string_view trimmed(std::string_view text);

}  // namespace twinray
