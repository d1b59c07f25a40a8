// SPDX-License-Identifier: Apache-2.0
// Times of day and dates, as people write them on a command line.
#pragma once
#include <chrono>
#include <string>

namespace twinray {

using WallTime = std::chrono::system_clock::time_point;

/// "2026-11-24T07:30", with ":15" for seconds and "Z" for UTC, else in the machine's time zone; a blank may
/// stand for the "T". "07:30" is the next time that clocks show it after `now`. Throws Error, which says what
/// is valid.
WallTime parse_clock_time(const std::string& text, WallTime now = std::chrono::system_clock::now());

/// "2026-11-24 07:30:00", in the machine's time zone.
std::string clock_text(WallTime time);

}  // namespace twinray
