// SPDX-License-Identifier: Apache-2.0
#include "io/diagnostic.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "io/utf8.h"

namespace twinray {
namespace {

constexpr std::size_t excerpt_length = 100, excerpt_before = 60;  // bytes, of a long line around a place

bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; }

int count_characters(std::string_view text) {
  return int(std::count_if(text.begin(), text.end(), [](char c) { return !is_continuation(c); }));
}

/// A line may hold tabs or bytes that a terminal would act on, or that are no letters.
std::string printable(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (static_cast<unsigned char>(c) < 32 || c == 127) c = ' ';
  return as_utf8(result);
}
/// So may names in messages, whose lines stay.
std::string printable_lines(std::string_view text) {
  std::string result;
  for (;;) {
    const std::size_t end = text.find('\n');
    result += printable(text.substr(0, end));
    if (end == std::string_view::npos) return result;
    result += '\n';
    text.remove_prefix(end + 1);
  }
}

/// Moves a cut so that it does not fall into a character.
std::size_t at_character(std::string_view text, std::size_t i) {
  while (i < text.size() && is_continuation(text[i])) ++i;
  return i;
}

void take_excerpt(std::string_view line, std::size_t at, Place& place) {
  const bool cut = line.size() > excerpt_length && at > excerpt_before;
  std::size_t begin = cut ? at_character(line, at - excerpt_before) : 0;
  if (!cut)
    while (begin < at && (line[begin] == ' ' || line[begin] == '\t')) ++begin;
  const std::size_t end = at_character(line, std::min(line.size(), begin + excerpt_length));
  const std::string head = cut ? "..." : "";
  const std::string tail = end < line.size() ? "..." : "";
  place.excerpt = head + printable(line.substr(begin, end - begin)) + tail;
  place.caret_column = int(head.size()) + count_characters(line.substr(begin, at - begin)) + 1;
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  const auto same = [](char x, char y) {
    return std::tolower(static_cast<unsigned char>(x)) == std::tolower(static_cast<unsigned char>(y));
  };
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        d[i][j] = i + j;
        continue;
      }
      d[i][j] =
          std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (same(a[i - 1], b[j - 1]) ? 0 : 1)});
      if (i > 1 && j > 1 && same(a[i - 1], b[j - 2]) && same(a[i - 2], b[j - 1]))
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[a.size()][b.size()];
}

/// A message that repeats a name of the file may be as long as the file: its middle is left out.
std::string shortened(const std::string& message) {
  constexpr std::size_t longest = 1000;
  if (message.size() <= longest) return message;
  std::size_t head = longest / 2, tail = message.size() - longest / 2;
  const auto is_within_character = [&](std::size_t i) { return (message[i] & 0xc0) == 0x80; };
  while (head > 0 && is_within_character(head)) --head;
  while (tail < message.size() && is_within_character(tail)) ++tail;
  return message.substr(0, head) + " ... " + message.substr(tail);
}

}  // namespace

Place place_of(const std::string& file, std::string_view text, std::size_t offset) {
  offset = std::min(offset, text.size());
  const std::string_view before = text.substr(0, offset);
  const std::size_t last_break = before.rfind('\n');
  const std::size_t begin = last_break == std::string_view::npos ? 0 : last_break + 1;
  std::size_t end = std::min(text.find('\n', offset), text.size());
  if (end > offset && text[end - 1] == '\r') --end;
  Place place;
  place.file = file;
  place.line = int(std::count(before.begin(), before.end(), '\n')) + 1;
  place.column = count_characters(text.substr(begin, offset - begin)) + 1;
  take_excerpt(text.substr(begin, end - begin), offset - begin, place);
  return place;
}

std::string message_at(const Place& place, const std::string& message) {
  const std::string text = printable_lines(shortened(message));
  if (place.line == 0) return fmt::format("{}: {}", place.file, text);
  return fmt::format("{}:{}:{}: {}\n  {}\n  {:>{}}", place.file, place.line, place.column, text,
                     place.excerpt, '^', place.caret_column);
}

PlacedError::PlacedError(const Place& place, const std::string& message)
    : Error(message_at(place, message)), place_(place), message_(message) {}

PlacedError error_at(const Place& place, const std::string& message) { return {place, message}; }

std::string Diagnostic::text() const {
  return message_at(place, count == 1 ? message : fmt::format("{} ({} times)", message, count));
}

void WarningList::add(const std::function<Place()>& where, const std::string& message) {
  if (strict_) throw error_at(where(), message);
  const auto known =
      std::find_if(items_.begin(), items_.end(), [&](const Diagnostic& d) { return d.message == message; });
  if (known != items_.end())
    ++known->count;
  else if (items_.size() < most_kept)
    items_.push_back({where(), message});
  else if (items_.size() == most_kept)
    items_.push_back({where(), "from here on further warnings are counted only"});
  else
    ++items_.back().count;
}

std::string nearest_name(std::string_view name, std::span<const std::string_view> known) {
  constexpr std::size_t longest = 64;  // a longer name is no slip of the keyboard
  std::string_view best;
  std::size_t best_distance = (name.size() + 2) / 3 + 1;
  if (name.size() > longest) return "";
  for (const std::string_view candidate : known) {
    const std::size_t distance = edit_distance(name, candidate);
    if (distance >= best_distance) continue;
    best = candidate;
    best_distance = distance;
  }
  return std::string(best);
}

std::string list_names(std::span<const std::string_view> names) {
  std::string list;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) list += i + 1 == names.size() ? " or " : ", ";
    list += names[i];
  }
  return list;
}

}  // namespace twinray
