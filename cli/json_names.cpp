// SPDX-License-Identifier: Apache-2.0
#include "cli/json_names.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/error.h"

namespace twinray {
namespace {

bool is_utf8(const std::string& text) {
  try {
    nlohmann::json(text).dump();
    return true;
  } catch (const nlohmann::json::type_error&) {
    return false;
  }
}

}  // namespace

void check_json_names(const std::vector<std::string>& names, const char* holder) {
  for (const std::string& name : names)
    if (!is_utf8(name))
      throw Error(
          fmt::format("{}: this name is not UTF-8, as all names in JSON are, which {} keeps them in; "
                      "give it another one",
                      name, holder));
}

}  // namespace twinray
