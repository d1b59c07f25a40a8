// SPDX-License-Identifier: Apache-2.0
#include "io/losses.h"

#include <fmt/format.h>

#include <algorithm>

namespace twinray {

void Losses::add(const std::string& one, const std::string& many) {
  auto kind = std::find_if(kinds_.begin(), kinds_.end(), [&](const Kind& k) { return k.one == one; });
  if (kind == kinds_.end()) kind = kinds_.insert(kind, {one, many});
  ++kind->count;
}

std::vector<std::string> Losses::lines(const std::string& file) const {
  std::vector<std::string> lines;
  for (const auto& [one, many, count] : kinds_) {
    std::string text = count == 1 ? one : many;
    if (const std::size_t place = text.find("{}"); count > 1 && place != text.npos)
      text.replace(place, 2, fmt::format("{}", count));
    lines.push_back(fmt::format("{}: {}", file, text));
  }
  return lines;
}

std::string article_of(const std::string& word) {
  return std::string("aeiou").find(word[0]) != std::string::npos ? "an" : "a";
}

}  // namespace twinray
