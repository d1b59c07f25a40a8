// SPDX-License-Identifier: Apache-2.0
#include "io/obj/text.h"

#include <algorithm>
#include <limits>

#include "io/decimal.h"

namespace twinray {
namespace {

/// Where the line of a byte begins, behind its blanks.
std::size_t line_begin(std::string_view text, std::size_t at) {
  const std::size_t end = text.substr(0, at).find_last_of("\r\n");
  return text.find_first_not_of(" \t", end == text.npos ? 0 : end + 1);
}

/// The first backslash from `from` on that continues its line; npos: none does.
std::size_t find_continuation(std::string_view text, std::size_t from) {
  for (std::size_t at = text.find('\\', from); at != text.npos; at = text.find('\\', at + 1)) {
    const std::string_view rest = text.substr(at + 1, 2);
    const bool is_last = rest.starts_with('\n') || rest == "\r\n";
    if (is_last && text[line_begin(text, at)] != '#') return at;
  }
  return text.npos;
}

float value_of(const Decimal<float>& number) {
  return number.fault == DecimalFault::too_large ? std::numeric_limits<float>::infinity() : number.value;
}

}  // namespace

bool has_continued_lines(std::string_view text) { return find_continuation(text, 0) != text.npos; }

std::string joined_lines(std::string text) {
  for (std::size_t at = 0; (at = find_continuation(text, at)) != text.npos;)
    for (const std::size_t end = text.find('\n', at); at <= end; ++at) text[at] = ' ';
  return text;
}

std::string_view take_word(std::string_view& line) {
  const auto is_blank = [](char c) { return c == ' ' || c == '\t'; };
  const auto begin = std::find_if_not(line.begin(), line.end(), is_blank);
  const std::string_view word(begin, std::find_if(begin, line.end(), is_blank));
  if (word.starts_with('#')) return line = "";
  line = {word.end(), line.end()};
  return word;
}

bool is_number(std::string_view word) {
  const DecimalFault fault = read_decimal<float>(word).fault;
  return fault == DecimalFault::none || fault == DecimalFault::too_large;
}

ObjNumbers read_numbers(std::string_view line) {
  ObjNumbers numbers;
  take_word(line);
  for (std::string_view word; !(word = take_word(line)).empty();) {
    const Decimal<float> number = read_decimal<float>(word);
    if (number.fault == DecimalFault::no_number || number.fault == DecimalFault::not_finite) {
      numbers.end = word;
      break;
    }
    if (numbers.count < numbers.values.size()) numbers.values[numbers.count++] = value_of(number);
  }
  return numbers;
}

}  // namespace twinray
