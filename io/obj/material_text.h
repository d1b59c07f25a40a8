// SPDX-License-Identifier: Apache-2.0
// Private: MTL files, as tinyobjloader can read them.
#pragma once
#include <string>

#include "io/diagnostic.h"

namespace twinray {

/// A statement that the library does not know and keeps, of materials that have `Pr`: it may be 0, as where
/// there is none.
inline constexpr const char* roughness_mark = "twinray:Pr";

/// A material file in the words that the library knows, and no others:
/// - continued lines are one;
/// - a colour of one number has it three times, `-s`, `-o` and `-t` have three numbers, or the library takes
///   the picture's name for one;
/// - `-cc` goes, which it takes for a picture's name, and `-halo`, which it takes for a number;
/// - a material without `Kd` has a black one: the library's is grey;
/// - behind `Pr` stands roughness_mark.
/// A number that is missing or none is 0, and a spectrum 0.5, with a warning; another one tells of options of
/// pictures that are not read, and of materials of which nothing says what they look like.
std::string material_text(const std::string& path, const std::string& text, WarningList& warnings);

}  // namespace twinray
