// SPDX-License-Identifier: Apache-2.0
#include "cli/json_names.h"

#include <fmt/format.h>

#include "core/error.h"
#include "io/utf8.h"

namespace twinray {

void check_json_names(const std::vector<std::string>& names, const char* holder) {
  for (const std::string& name : names)
    if (!is_utf8(name))
      throw Error(
          fmt::format("{}: this name is not UTF-8, as all names in JSON are, which {} keeps them in; "
                      "give it another one",
                      name, holder));
}

}  // namespace twinray
