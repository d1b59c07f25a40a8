// SPDX-License-Identifier: Apache-2.0
#include "bench/pattern.h"

#include <fmt/format.h>
#include <regex.h>

#include "core/error.h"

namespace twinray::bench {

struct Pattern::Compiled {
  regex_t regex;
  explicit Compiled(const std::string& expression) {
    if (regcomp(&regex, expression.c_str(), REG_EXTENDED | REG_NOSUB) != 0)
      throw UsageError(fmt::format("\"{}\" is not a regular expression", expression));
  }
  ~Compiled() { regfree(&regex); }
  Compiled(const Compiled&) = delete;
  Compiled& operator=(const Compiled&) = delete;
};

Pattern::Pattern(const std::string& expression) : compiled_(std::make_shared<const Compiled>(expression)) {}

bool Pattern::matches(const std::string& text) const {
  return regexec(&compiled_->regex, text.c_str(), 0, nullptr, 0) == 0;
}

}  // namespace twinray::bench
