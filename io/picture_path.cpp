// SPDX-License-Identifier: Apache-2.0
#include "io/picture_path.h"

#include <algorithm>
#include <filesystem>

#include "io/uri.h"

namespace twinray {

std::string found_picture(const std::string& path, const std::string& from_file) {
  const std::string beside = path_of_name(std::filesystem::path(path).filename().string(), from_file);
  std::error_code error;
  return !std::filesystem::exists(path, error) && std::filesystem::exists(beside, error) ? beside : path;
}

std::string with_slashes(std::string name) {
  std::replace(name.begin(), name.end(), '\\', '/');
  return name;
}

}  // namespace twinray
