// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>
#include <string>

namespace twinray::bench {

/// An extended regular expression (POSIX), compiled once.
class Pattern {
 public:
  /// Throws UsageError for what is no regular expression.
  explicit Pattern(const std::string& expression);
  /// Whether some part of the text matches; the empty expression matches everything.
  bool matches(const std::string& text) const;

 private:
  struct Compiled;
  std::shared_ptr<const Compiled> compiled_;
};

}  // namespace twinray::bench
