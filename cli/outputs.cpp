// SPDX-License-Identifier: Apache-2.0
#include "cli/outputs.h"

#include <fmt/format.h>
#include <limits.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "cli/console.h"
#include "core/error.h"
#include "io/destination.h"
#include "io/output_file.h"

namespace twinray {

void prepare_outputs(const std::vector<std::string>& names, const std::vector<std::string>& read) {
  check_outputs(names);
  check_not_read(names, read);
  if (std::any_of(names.begin(), names.end(), is_standard_output)) console::keep_output_for_data();
}

void check_not_read(const std::vector<std::string>& written, const std::vector<std::string>& read) {
  for (const std::string& path : written)
    for (const std::string& file : read) {
      std::error_code error;  // Of a file that is not there: it is another one.
      if (std::filesystem::is_regular_file(path, error) && std::filesystem::equivalent(path, file, error))
        throw Error(fmt::format("{}: this file is read; choose another name", path));
    }
}

std::vector<std::string> given_names(std::vector<std::string> names) {
  std::erase(names, "");
  return names;
}

std::string name_beside(const std::string& name, const std::string& ending) {
  return std::filesystem::path(name).replace_extension().string() + ending;
}

std::string partial_name(const std::string& name) {
  if (name.empty()) return "";
  const std::filesystem::path path(name);
  const std::string ending = "_partial" + path.extension().string();
  return (path.parent_path() / (path.stem().string().substr(0, NAME_MAX - ending.size()) + ending)).string();
}

}  // namespace twinray
