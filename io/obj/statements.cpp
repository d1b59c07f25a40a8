// SPDX-License-Identifier: Apache-2.0
#include "io/obj/statements.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "io/obj/text.h"

namespace twinray {
namespace {

/// Those that are read, or change nothing of triangles: the most frequent first.
constexpr std::array<std::string_view, 37> silent{
    "v",     "f",     "vn",   "vt",        "",           "g",        "usemtl", "s",      "o",   "mtllib",
    "vp",    "deg",   "bmat", "step",      "cstype",     "parm",     "trim",   "hole",   "sp",  "scrv",
    "end",   "con",   "mg",   "bevel",     "c_interp",   "d_interp", "lod",    "maplib", "bzp", "bsp",
    "ctech", "stech", "csh",  "trace_obj", "shadow_obj", "cdc",      "res"};

struct LeftOut {
  std::string_view statement, what;
};
constexpr std::array<LeftOut, 7> left_out{{{"l", "lines (\"l\")"},
                                           {"p", "points (\"p\")"},
                                           {"curv", "curves (\"curv\")"},
                                           {"curv2", "curves (\"curv2\")"},
                                           {"surf", "curved surfaces (\"surf\")"},
                                           {"call", "other files (\"call\")"},
                                           {"usemap", "pictures of \"usemap\""}}};

}  // namespace

std::vector<std::string> check_obj_statements(std::string_view text,
                                              const std::function<Place(std::size_t)>& place,
                                              WarningList& warnings) {
  std::array<std::size_t, left_out.size()> counts{};
  const auto is_line_end = [](char c) { return c == '\n' || c == '\r'; };
  for (auto at = text.begin(); at != text.end();) {
    const auto end = std::find_if(at, text.end(), is_line_end);
    std::string_view line(at, end);
    const auto begin = std::size_t(at - text.begin());
    at = end == text.end() ? end : std::next(end);
    const std::string_view word = take_word(line);
    if (std::find(silent.begin(), silent.end(), word) != silent.end()) continue;
    const auto known = std::find_if(left_out.begin(), left_out.end(),
                                    [&](const LeftOut& entry) { return entry.statement == word; });
    if (known != left_out.end())
      ++counts[std::size_t(known - left_out.begin())];
    else
      warnings.add([&] { return place(begin); }, fmt::format("\"{}\" is not known; it is left out", word));
  }
  std::vector<std::string> notes;
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (counts[i] > 0) notes.push_back(fmt::format("{} are left out: {}", left_out[i].what, counts[i]));
  return notes;
}

}  // namespace twinray
