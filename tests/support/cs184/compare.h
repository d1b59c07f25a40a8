// SPDX-License-Identifier: Apache-2.0
// Our picture of normals by CS184's rules, beside the reference's.
#pragma once
#include <string>

#include "tests/support/cs184/picture.h"

namespace twinray::test::cs184 {

/// What part of a picture's pixels differs.
struct Difference {
  double beyond_one_step = 0;  ///< By more than one step of 255 in some channel.
  double outline = 0;          ///< One shows a surface and the other none.
  double covered = 0;          ///< Not what differs, but where the reference shows a surface.
};

/// Of a scene file, in a picture of that size.
Difference difference_of_file(const std::string& path, int width, int height);
/// Of a COLLADA document.
Difference difference_of_text(const std::string& collada, int width, int height);

}  // namespace twinray::test::cs184
