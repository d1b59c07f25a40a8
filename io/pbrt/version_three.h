// SPDX-License-Identifier: Apache-2.0
// What pbrt-v3's files say in words that pbrt-v4's have no more.
#pragma once
#include <algorithm>
#include <string_view>

namespace twinray {

/// Goes behind a message that a word is unknown: a hint where it is one of pbrt-v3's films, materials, types
/// of textures or directives; else nothing.
constexpr std::string_view version_three_hint(std::string_view word) {
  constexpr std::string_view words[] = {"image",  "matte",  "plastic",   "metal",      "uber",
                                        "glass",  "mirror", "substrate", "fourier",    "kdsubsurface",
                                        "disney", "color",  "WorldEnd",  "translucent"};
  const bool is_known = std::find(std::begin(words), std::end(words), word) != std::end(words);
  return is_known ? "; the file is pbrt-v3's, which `pbrt --upgrade` of pbrt-v4 rewrites" : "";
}

}  // namespace twinray
