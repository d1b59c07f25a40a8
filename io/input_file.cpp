// SPDX-License-Identifier: Apache-2.0
#include "io/input_file.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>

#include "core/error.h"

namespace twinray {
namespace {

void check_size(const std::string& path, std::uintmax_t bytes) {
  if (bytes > max_input_bytes)
    throw Error(fmt::format("{}: the file has {} bytes; at most {} are read", path, bytes, max_input_bytes));
}

/// The status of a file that is there, and is no directory.
std::filesystem::file_status status_of(const std::string& path, const char* needed) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::none)
    throw Error(fmt::format("{}: cannot be looked at: {}", path, error.message()));
  if (!std::filesystem::exists(status)) throw Error(path + ": there is no such file");
  if (std::filesystem::is_directory(status))
    throw Error(fmt::format("{}: this is a directory; a {} is needed", path, needed));
  return status;
}

}  // namespace

void check_regular_file(const std::string& path, const char* needed) {
  if (!std::filesystem::is_regular_file(status_of(path, needed)))
    throw Error(fmt::format("{}: this is no regular file; a {} is needed", path, needed));
}

std::string read_input_file(const std::string& path, const char* needed) {
  status_of(path, needed);
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);  // a FIFO has none before it is read
  if (!error) check_size(path, size);
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw Error(path + ": the file cannot be opened; may it be read?");
  std::string text;
  if (!error) text.reserve(std::size_t(size));
  char block[1 << 16];
  while (stream.read(block, sizeof block) || stream.gcount() > 0) {
    text.append(block, std::size_t(stream.gcount()));
    check_size(path, text.size());
  }
  if (stream.bad()) throw Error(path + ": the file cannot be read to its end");
  return text;
}

}  // namespace twinray
