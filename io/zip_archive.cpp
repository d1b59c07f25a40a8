// SPDX-License-Identifier: Apache-2.0
#include "io/zip_archive.h"

#include <fmt/format.h>
#include <zip.h>

#include <algorithm>
#include <filesystem>

#include "core/error.h"

namespace twinray {
namespace {

struct CloseFile {
  void operator()(zip_file_t* file) const { zip_fclose(file); }
};
using OpenFile = std::unique_ptr<zip_file_t, CloseFile>;

std::string reason(int code) {
  zip_error_t error;
  zip_error_init_with_code(&error, code);
  const std::string text = zip_error_strerror(&error);
  zip_error_fini(&error);
  return text;
}

}  // namespace

void ZipArchive::Close::operator()(zip* archive) const { zip_discard(archive); }

ZipArchive::ZipArchive(const std::string& path) : path_(path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) throw Error(fmt::format("{}: there is no such file", path));
  int code = 0;
  archive_.reset(zip_open(path.c_str(), ZIP_RDONLY, &code));
  if (!archive_) throw Error(fmt::format("{}: not a zip archive that can be read ({})", path, reason(code)));
}

std::vector<std::string> ZipArchive::names() const {
  std::vector<std::string> result;
  for (zip_int64_t i = 0; i < zip_get_num_entries(archive_.get(), 0); ++i)
    if (const char* name = zip_get_name(archive_.get(), zip_uint64_t(i), 0)) result.emplace_back(name);
  return result;
}

bool ZipArchive::has(const std::string& name) const {
  return zip_name_locate(archive_.get(), name.c_str(), 0) >= 0;
}

void ZipArchive::fail(const std::string& name, const std::string& message) const {
  throw Error(fmt::format("{}/{}: {}", path_, name, message));
}

void ZipArchive::check_size(const std::string& name, std::uint64_t size, std::uint64_t packed) const {
  if (size > max_bytes)
    fail(name, fmt::format("unpacked the file has {} bytes; at most {} are read", size, max_bytes));
  if (size > small_bytes && size / most_growth > packed)
    fail(name,
         fmt::format("{} bytes become {} when they are unpacked; beyond {} bytes, at most {} times as many "
                     "are read",
                     packed, size, small_bytes, most_growth));
}

std::string ZipArchive::read(const std::string& name) const {
  zip_stat_t stat;
  zip_stat_init(&stat);
  if (zip_stat(archive_.get(), name.c_str(), 0, &stat) != 0)
    fail(name, "there is no such file in the archive");
  constexpr zip_uint64_t needed = ZIP_STAT_SIZE | ZIP_STAT_COMP_SIZE | ZIP_STAT_INDEX;
  if ((stat.valid & needed) != needed) fail(name, "the archive does not say how large this file is");
  check_size(name, stat.size, stat.comp_size);
  const OpenFile file(zip_fopen_index(archive_.get(), stat.index, 0));
  if (!file) fail(name, fmt::format("cannot be unpacked ({})", zip_strerror(archive_.get())));
  std::string text;
  char block[1 << 16];
  zip_int64_t got = 0;
  while ((got = zip_fread(file.get(), block, sizeof block)) > 0) {
    text.append(block, std::size_t(got));
    if (text.size() > stat.size) fail(name, "it is larger than the archive says: the archive is damaged");
  }
  if (got < 0 || text.size() != stat.size)
    fail(name, fmt::format("cannot be unpacked to its end: the archive is damaged ({})",
                           zip_file_strerror(file.get())));
  return text;
}

}  // namespace twinray
