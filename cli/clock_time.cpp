// SPDX-License-Identifier: Apache-2.0
#include "cli/clock_time.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <optional>
#include <string_view>

#include "core/error.h"

namespace twinray {
namespace {

/// The numbers of a text, in which each digit of the pattern stands for a digit and all else for itself.
template <std::size_t count>
std::optional<std::array<int, count>> numbers_of(std::string_view text, std::string_view pattern) {
  if (text.size() != pattern.size()) return std::nullopt;
  std::array<int, count> numbers{};
  std::size_t number = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_digit = text[i] >= '0' && text[i] <= '9';
    if (pattern[i] != '0' ? text[i] != pattern[i] : !is_digit) return std::nullopt;
    if (!is_digit)
      ++number;
    else
      numbers.at(number) = 10 * numbers.at(number) + (text[i] - '0');
  }
  return numbers;
}

struct TimeOfDay {
  int hour = 0, minute = 0, second = 0;
};

std::optional<TimeOfDay> time_of_day(std::string_view text) {
  std::optional<TimeOfDay> time;
  if (const auto long_time = numbers_of<3>(text, "00:00:00"))
    time = {(*long_time)[0], (*long_time)[1], (*long_time)[2]};
  else if (const auto short_time = numbers_of<2>(text, "00:00"))
    time = {(*short_time)[0], (*short_time)[1], 0};
  return time && time->hour < 24 && time->minute < 60 && time->second < 60 ? time : std::nullopt;
}

/// Of a day, which may lie beyond the end of its month.
std::tm calendar(int year, int month, int day, const TimeOfDay& time) {
  std::tm fields{};
  fields.tm_year = year - 1900;
  fields.tm_mon = month - 1;
  fields.tm_mday = day;
  fields.tm_hour = time.hour;
  fields.tm_min = time.minute;
  fields.tm_sec = time.second;
  fields.tm_isdst = -1;  // The zone's rules say whether it is summer time.
  return fields;
}

std::tm local_fields(WallTime time) {
  const std::time_t seconds = std::chrono::system_clock::to_time_t(time);
  std::tm fields{};
  localtime_r(&seconds, &fields);
  return fields;
}

/// The last second that a WallTime can say comes long after any render.
WallTime wall_time(std::time_t seconds) {
  constexpr auto last = std::chrono::floor<std::chrono::seconds>(WallTime::max().time_since_epoch());
  return std::chrono::system_clock::from_time_t(std::min(seconds, std::time_t(last.count())));
}

WallTime local_time(std::tm fields) { return wall_time(std::mktime(&fields)); }

WallTime next_time(const TimeOfDay& time, WallTime now) {
  const std::tm today = local_fields(now);
  const auto on_day = [&](int days_later) {
    return local_time(calendar(today.tm_year + 1900, today.tm_mon + 1, today.tm_mday + days_later, time));
  };
  const WallTime first = on_day(0);
  return first > now ? first : on_day(1);
}

bool is_date(int year, int month, int day) {
  using namespace std::chrono;
  return year >= 1970 && year_month_day(std::chrono::year(year), std::chrono::month(unsigned(month)),
                                        std::chrono::day(unsigned(day)))
                             .ok();
}

std::optional<WallTime> dated_time(std::string_view text) {
  constexpr std::size_t date_length = 10;
  if (text.size() <= date_length || (text[date_length] != 'T' && text[date_length] != ' ')) return {};
  const bool is_utc = text.ends_with('Z');
  std::string_view clock = text.substr(date_length + 1);
  if (is_utc) clock.remove_suffix(1);
  const auto date = numbers_of<3>(text.substr(0, date_length), "0000-00-00");
  const std::optional<TimeOfDay> time = time_of_day(clock);
  if (!date || !time) return {};
  const auto [year, month, day] = *date;
  if (!is_date(year, month, day)) return {};
  std::tm fields = calendar(year, month, day, *time);
  return is_utc ? wall_time(timegm(&fields)) : local_time(fields);
}

}  // namespace

WallTime parse_clock_time(const std::string& text, WallTime now) {
  if (const std::optional<TimeOfDay> time = time_of_day(text)) return next_time(*time, now);
  if (const std::optional<WallTime> time = dated_time(text)) return *time;
  throw Error(
      fmt::format("\"{}\" is no time; valid are 07:30, 2026-11-24T07:30, 2026-11-24T07:30:00Z", text));
}

std::string clock_text(WallTime time) {
  const std::tm fields = local_fields(time);
  return fmt::format("{:04}-{:02}-{:02} {:02}:{:02}:{:02}", fields.tm_year + 1900, fields.tm_mon + 1,
                     fields.tm_mday, fields.tm_hour, fields.tm_min, fields.tm_sec);
}

}  // namespace twinray
