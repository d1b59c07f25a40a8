// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <string>

#include "io/diagnostic.h"

namespace twinray {

/// A file of pbrt's text format, unpacked.
struct PbrtFile {
  std::string name;
  std::string text;
};

/// A byte of such a file, which must live as long.
struct PbrtPlace {
  const PbrtFile* file = nullptr;
  std::size_t offset = 0;
  int line = 1;

  Place place() const { return place_of(file->name, file->text, offset); }
  /// Throws the error with this place.
  [[noreturn]] void fail(const std::string& message) const { throw error_at(place(), message); }
  void warn(WarningList& warnings, const std::string& message) const {
    warnings.add([this] { return place(); }, message);
  }
};

}  // namespace twinray
