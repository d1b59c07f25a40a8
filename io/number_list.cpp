// SPDX-License-Identifier: Apache-2.0
#include "io/number_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>

#include "io/decimal.h"

namespace twinray {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

/// Calls visit(token, offset) for each token.
template <typename Visit>
void for_each_token(std::string_view text, const Visit& visit) {
  std::size_t i = 0;
  while (true) {
    while (i < text.size() && is_space(text[i])) ++i;
    if (i == text.size()) return;
    const std::size_t begin = i;
    while (i < text.size() && !is_space(text[i])) ++i;
    visit(text.substr(begin, i - begin), begin);
  }
}

std::string shown(std::string_view token) {
  constexpr std::size_t longest = 32;
  return token.size() <= longest ? std::string(token) : std::string(token.substr(0, longest)) + "...";
}

/// What keeps a token that from_chars did not take from being a number.
std::string problem(std::string_view token) {
  if (token.find(',') != std::string_view::npos)
    return fmt::format("\"{}\" is not a number: decimals have a point, and numbers are separated by spaces",
                       shown(token));
  return fmt::format("\"{}\" is not a number; valid are decimal numbers such as -1.5 or 2e-3", shown(token));
}

template <typename Real>
Real parse_real(std::string_view token, std::size_t offset) {
  const Decimal<Real> number = read_decimal<Real>(token);
  switch (number.fault) {
    case DecimalFault::none:
      return number.value;
    case DecimalFault::no_number:
      throw NumberError{offset, problem(token)};
    case DecimalFault::too_large:
      throw NumberError{offset, fmt::format("\"{}\" is too large; numbers lie within +-{:.2g}", shown(token),
                                            std::numeric_limits<Real>::max())};
    case DecimalFault::not_finite:
      break;
  }
  throw NumberError{offset, fmt::format("\"{}\" is not finite; every number must be", shown(token))};
}

std::size_t count_tokens(std::string_view text) {
  std::size_t count = 0;
  bool was_space = true;
  for (const char c : text) {
    count += was_space && !is_space(c);
    was_space = is_space(c);
  }
  return count;
}

template <typename Real>
std::vector<Real> parse_reals(std::string_view text) {
  std::vector<Real> values;
  values.reserve(count_tokens(text));
  for_each_token(text, [&](std::string_view token, std::size_t offset) {
    values.push_back(parse_real<Real>(token, offset));
  });
  return values;
}

/// Whether a token is what programs write for a number that is none or infinite: "nan", "-nan(ind)", "INF",
/// "Infinity"; and Microsoft's "1.#QNAN", "-1.#IND", "1.#INF00".
bool is_not_finite(std::string_view token) {
  if (token.size() > 1 && (token[0] == '-' || token[0] == '+')) token.remove_prefix(1);
  if (token.substr(0, 3) == "1.#") return token.size() > 3;
  const char first = char(token[0] | 0x20);  // in lower case, if it is a letter
  if (first != 'n' && first != 'i') return false;
  std::string lower(token);
  for (char& c : lower) c = char(c | 0x20);
  return lower == "nan" || lower == "inf" || lower == "infinity" || lower.rfind("nan(", 0) == 0;
}

}  // namespace

std::vector<double> parse_doubles(std::string_view text) { return parse_reals<double>(text); }
std::vector<float> parse_floats(std::string_view text) { return parse_reals<float>(text); }

std::vector<float> parse_floats_or_nan(std::string_view text) {
  std::vector<float> values;
  values.reserve(count_tokens(text));
  for_each_token(text, [&](std::string_view token, std::size_t offset) {
    values.push_back(is_not_finite(token) ? std::numeric_limits<float>::quiet_NaN()
                                          : parse_real<float>(token, offset));
  });
  return values;
}

std::vector<std::uint32_t> parse_indices(std::string_view text) {
  std::vector<std::uint32_t> values;
  values.reserve(count_tokens(text));
  for_each_token(text, [&](std::string_view token, std::size_t offset) {
    std::uint32_t value = 0;
    const char* end = token.data() + token.size();
    const auto [stop, error] = std::from_chars(token.data(), end, value);
    if (stop != end || error != std::errc())
      throw NumberError{offset, fmt::format("\"{}\" is not a whole number from 0 to {}", shown(token),
                                            std::numeric_limits<std::uint32_t>::max())};
    values.push_back(value);
  });
  return values;
}

std::size_t token_offset(std::string_view text, std::size_t index) {
  std::size_t found = text.size(), count = 0;
  for_each_token(text, [&](std::string_view, std::size_t offset) {
    if (count++ == index) found = offset;
  });
  return found;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

}  // namespace twinray
