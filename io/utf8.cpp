// SPDX-License-Identifier: Apache-2.0
#include "io/utf8.h"

#include <nlohmann/json.hpp>

namespace twinray {

bool is_utf8(const std::string& text) {
  try {
    nlohmann::json(text).dump();
    return true;
  } catch (const nlohmann::json::type_error&) {
    return false;
  }
}

std::string as_utf8(const std::string& text) {
  if (is_utf8(text)) return text;
  std::string letters;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      letters += c;
      continue;
    }
    letters += char(0xc0 | byte >> 6);
    letters += char(0x80 | (byte & 0x3f));
  }
  return letters;
}

}  // namespace twinray
