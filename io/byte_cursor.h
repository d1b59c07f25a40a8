// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

#include "core/error.h"

namespace twinray {

/// Takes what a binary file of the machine's byte order has next.
class ByteCursor {
 public:
  /// `file` is how messages begin: "a.nvdb: the NanoVDB file".
  ByteCursor(std::string_view bytes, std::string file) : rest_(bytes), file_(std::move(file)) {}

  bool is_at_end() const { return rest_.empty(); }
  /// Throws Error where there are not so many bytes; `what` is then cut off.
  std::string_view take(std::uint64_t size, const char* what) {
    if (size > rest_.size()) throw Error(file_ + " is cut off in " + what);
    const std::string_view taken = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return taken;
  }
  /// The same of a value that is no more than its bytes.
  template <typename T>
  T take(const char* what) {
    T value;
    std::memcpy(&value, take(sizeof value, what).data(), sizeof value);
    return value;
  }

 private:
  std::string_view rest_;
  std::string file_;
};

}  // namespace twinray
