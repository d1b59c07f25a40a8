// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

namespace twinray {

/// The path of a picture that a file names: `path`, or, where no file has it and one of the same name lies
/// beside `from_file`, that one. Exporters write paths of other systems, and of folders that were theirs
/// alone.
std::string found_picture(const std::string& path, const std::string& from_file);

/// A file's name with slashes for backslashes.
std::string with_slashes(std::string name);

}  // namespace twinray
