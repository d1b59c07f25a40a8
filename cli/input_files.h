// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <map>
#include <string>

#include "cli/render_arguments.h"

namespace twinray {

/// The files that a render depends on, by their names as seen from the scene's folder, and the hash of each,
/// "none" for one that cannot be read; of a generated scene its name alone. The scene was loaded with a list
/// of its files.
using InputFiles = std::map<std::string, std::string>;
InputFiles input_files(const RenderArguments& arguments);

/// A line for each file with its hash before it, as sha256sum writes it; and back again. Lines that are none
/// of this form are left out.
std::string input_text(const InputFiles& files);
InputFiles parse_input_text(const std::string& text);

/// What is different between those of something that was made and others, which are called `other` ("here",
/// "there"): "a.ply is another file here"; empty: nothing.
std::string file_difference(const InputFiles& files, const InputFiles& others, const char* other);

}  // namespace twinray
