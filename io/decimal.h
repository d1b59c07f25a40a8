// SPDX-License-Identifier: Apache-2.0
// Words as decimal numbers, and numbers as such: what readers and writers of text files have in common. Each
// has messages of its own.
#pragma once
#include <charconv>
#include <cmath>
#include <string_view>

namespace twinray {

/// What keeps a word from being a number.
enum class DecimalFault { none, no_number, too_large, not_finite };

template <typename Number>
struct Decimal {
  Number value{};  ///< 0 where there is a fault, and for numbers too small for the type.
  DecimalFault fault = DecimalFault::none;
};

/// Of a number that from_chars finds "out of range", which it says of those too small as well as too large.
inline bool is_tiny(std::string_view digits) {
  constexpr std::size_t longest = 64;  // so that the digits cannot outweigh the exponent
  const std::size_t e = digits.find_first_of("eE");
  return digits.size() <= longest && e != std::string_view::npos && e + 1 < digits.size() &&
         digits[e + 1] == '-';
}

/// The number that the word is as a whole: "-1.5e3", "+2"; rounded once to the type. "nan" and "inf" are not
/// finite.
template <typename Number>
Decimal<Number> read_decimal(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  Number value{};
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (stop != end || error == std::errc::invalid_argument) return {{}, DecimalFault::no_number};
  if (error == std::errc::result_out_of_range)
    return {{}, is_tiny(word) ? DecimalFault::none : DecimalFault::too_large};
  if (!std::isfinite(double(value))) return {{}, DecimalFault::not_finite};
  return {value};
}

/// The double whose text is the shortest one that means this float.
inline double shortest_decimal(float x) {
  char digits[32];
  const auto written = std::to_chars(digits, digits + sizeof digits, x);
  double decimal = double(x);
  std::from_chars(digits, written.ptr, decimal);
  return decimal;
}

}  // namespace twinray
