// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <string_view>

#include "core/error.h"

namespace twinray {

struct PictureSize {
  long long width = 0, height = 0;
};

/// The bytes of a picture's file, and the name by which messages call it.
struct PictureBytes {
  std::string_view bytes;
  const std::string& path;
};

/// Throws the Error of a picture that cannot be read for this reason.
[[noreturn]] inline void fail_picture(const PictureBytes& picture, const std::string& reason) {
  throw Error(picture.path + ": cannot be read: " + reason);
}

}  // namespace twinray
