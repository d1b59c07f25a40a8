// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "io/diagnostic.h"
#include "io/load_options.h"

namespace twinray {

/// Gives the bytes of a file that a glTF file names, by its path; throws Error.
using GltfRead = std::function<std::string(const std::string& path)>;

/// What all parts of the reader share. A place within the file is a JSON pointer (RFC 6901): "/meshes/3".
struct GltfContext {
  std::string file;
  LoadOptions options;
  GltfRead read;
  bool read_pictures = true;  ///< Those that stand in files of their own.
  WarningList warnings{options.strict};
  std::vector<std::string> notes = {};  ///< Of the summary: decisions that change the picture little.

  [[noreturn]] void fail(const std::string& pointer, const std::string& message) const {
    throw error_at({file + ": " + pointer}, message);
  }
  void warn(const std::string& pointer, const std::string& message) {
    warnings.add([&] { return Place{file + ": " + pointer}; }, message);
  }
};

}  // namespace twinray
