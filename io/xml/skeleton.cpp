// SPDX-License-Identifier: Apache-2.0
#include "io/xml/skeleton.h"

#include <algorithm>

#include "io/xml/lexer.h"

namespace twinray {
namespace {

/// Runs up to this length stay whole; of longer ones so much does.
constexpr std::size_t kept = 256;

void append_run(std::string_view run, std::string& skeleton) {
  skeleton += run.substr(0, kept);
  if (run.size() > kept) skeleton.append(std::size_t(std::count(run.begin() + kept, run.end(), '\n')), '\n');
}

}  // namespace

std::string xml_skeleton(std::string_view text) {
  std::string skeleton;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t begin = std::min(text.find('<', i), text.size());
    append_run(text.substr(i, begin - i), skeleton);
    i = behind_markup(text, begin);
    skeleton += text.substr(begin, i - begin);
  }
  return skeleton;
}

}  // namespace twinray
