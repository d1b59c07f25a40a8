// SPDX-License-Identifier: Apache-2.0
#include "io/output_file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "core/error.h"

namespace twinray {

namespace fs = std::filesystem;

std::string temporary_path(const std::string& path) {
  const fs::path target(path);
  return (target.parent_path() / fmt::format(".{}.{}.part", target.filename().string(), getpid())).string();
}

void check_output(const std::string& path) {
  const fs::path folder = fs::path(path).has_parent_path() ? fs::path(path).parent_path() : fs::path(".");
  if (!fs::is_directory(folder)) throw Error(fmt::format("{}: there is no folder {}", path, folder.string()));
  if (fs::is_directory(path)) throw Error(fmt::format("{}: cannot be written: it is a folder", path));
  const OutputFile probe(path);
  if (!std::ofstream(probe.path()))
    throw Error(fmt::format("{}: the folder {} is not writable", path, folder.string()));
}

OutputFile::~OutputFile() {
  std::error_code ignored;
  if (!path_.empty()) fs::remove(path_, ignored);
}

void OutputFile::finish() {
  std::error_code error;
  fs::rename(path_, target_, error);
  if (error) throw Error(fmt::format("{}: cannot be written: {}", target_, error.message()));
  path_.clear();
}

void write_text_file(const std::string& path, const std::string& text) {
  OutputFile file(path);
  std::ofstream stream(file.path(), std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) throw Error(fmt::format("{}: cannot be written", path));
  file.finish();
}

}  // namespace twinray
