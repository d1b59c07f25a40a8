// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/files.h"

#include <filesystem>

#include "io/gzip.h"
#include "io/input_file.h"

namespace twinray {
namespace {

std::filesystem::path beside(const std::string& file, const std::string& name) {
  return std::filesystem::path(file).parent_path() / name;  // an absolute name stays as it is
}

}  // namespace

PbrtFiles::PbrtFiles(const std::string& scene, Read read, const LoadOptions& options)
    : scene_(scene), read_(std::move(read)), options_(options) {}

std::string PbrtFiles::path(const PbrtPlace& place, const std::string& name) const {
  if (name.find('\0') != std::string::npos) place.fail("the name of a file has a zero byte");
  const std::filesystem::path first = beside(scene_, name), second = beside(place.file->name, name);
  std::error_code error;
  const bool is_second =
      is_disk() && !std::filesystem::exists(first, error) && std::filesystem::exists(second, error);
  return (is_second ? second : first).string();
}

std::string PbrtFiles::bytes(const PbrtPlace& place, const std::string& path) const {
  options_.add_file(path);
  try {
    return read_ ? read_(path) : read_unpacked(path);
  } catch (const Error& error) {
    place.fail(error.what());
  }
}

}  // namespace twinray
