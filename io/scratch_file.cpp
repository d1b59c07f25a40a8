// SPDX-License-Identifier: Apache-2.0
#include "io/scratch_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "core/error.h"

namespace twinray {
namespace {

[[noreturn]] void fail(const std::string& folder, const char* what, int error) {
  throw Error(fmt::format("{}: a temporary file there {}: {}; TMPDIR names another folder", folder, what,
                          std::strerror(error)));
}

/// Not every file system knows files without a name: then it has one for a moment.
int open_nameless(const std::string& folder) {
  const int nameless = open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (nameless >= 0) return nameless;
  std::string name = folder + "/twinray-XXXXXX";
  const int named = mkostemp(name.data(), O_CLOEXEC);
  if (named >= 0) unlink(name.c_str());
  return named;
}

}  // namespace

ScratchFile::ScratchFile() {
  std::error_code error;
  folder_ = std::filesystem::temp_directory_path(error).string();
  if (error) fail(std::getenv("TMPDIR") ? std::getenv("TMPDIR") : "/tmp", "cannot be made", error.value());
  descriptor_ = open_nameless(folder_);
  if (descriptor_ < 0) fail(folder_, "cannot be made", errno);
}

ScratchFile::~ScratchFile() { close(descriptor_); }

void ScratchFile::append(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = pwrite(descriptor_, bytes.data(), bytes.size(), off_t(size_));
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) fail(folder_, "cannot be written", written < 0 ? errno : ENOSPC);
    size_ += std::uint64_t(written);
    bytes = bytes.subspan(std::size_t(written));
  }
}

void ScratchFile::read(std::uint64_t place, std::span<std::byte> bytes) const {
  while (!bytes.empty()) {
    const ssize_t count = pread(descriptor_, bytes.data(), bytes.size(), off_t(place));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) fail(folder_, "cannot be read", count < 0 ? errno : ENODATA);
    place += std::uint64_t(count);
    bytes = bytes.subspan(std::size_t(count));
  }
}

}  // namespace twinray
