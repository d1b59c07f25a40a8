// SPDX-License-Identifier: Apache-2.0
#include "io/output_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <unordered_map>
#include <utility>

#include "core/error.h"
#include "io/destination.h"

namespace twinray {
namespace {

namespace fs = std::filesystem;

/// A temporary name begins with this much of the file's, so that it is never too long itself.
constexpr std::size_t kept_of_name = 200;

std::string temporary_path_of(const Destination& to) {
  if (to.kind != Destination::Kind::file) return "";
  const fs::path path(to.path);
  return path.parent_path() /
         fmt::format(".{:.{}}.{}.part", path.filename().string(), kept_of_name, getpid());
}

/// So that the file's new name survives a loss of power as its bytes do. What cannot is left to the system.
void flush_folder_of(const std::string& path) {
  const fs::path folder = fs::path(path).parent_path();
  const int descriptor = open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  fsync(descriptor);
  close(descriptor);
}

/// Gives a file, if there is one, a second name; else whatever has that keeps it. There is no moment without
/// the first one, unless the file system knows no second names.
void keep_as(const std::string& path, const std::string& second) {
  if (access(path.c_str(), F_OK) != 0) return;
  unlink(second.c_str());
  if (link(path.c_str(), second.c_str()) != 0 && errno != ENOENT) std::rename(path.c_str(), second.c_str());
}

/// Opening a FIFO would wait for its reader, and disturb it: what is written into is asked for its permission
/// alone.
void check_output(const Destination& to) {
  if (to.kind == Destination::Kind::descriptor) {
    const int flags = fcntl(to.descriptor, F_GETFL);
    if (flags < 0 || (flags & O_ACCMODE) == O_RDONLY)
      throw Error(fmt::format("{}: cannot be written: {}", to.name, std::strerror(EBADF)));
    return;
  }
  if (access(to.path.c_str(), W_OK) != 0 && errno != ENOENT)
    throw Error(fmt::format("{}: cannot be written: {}", to.name, std::strerror(errno)));
  if (to.kind == Destination::Kind::file) OutputFile(to).take_mode_and_owner();
}

}  // namespace

OutputFile::OutputFile(Destination to)
    : to_(std::move(to)), temporary_(temporary_path_of(to_)), descriptor_(open_descriptor()) {
  if (descriptor_ < 0) fail(errno);
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) close(descriptor_);
  if (!temporary_.empty()) unlink(temporary_.c_str());
}

void OutputFile::take_mode_and_owner() const {
  struct stat old {
  }, anew{};
  if (to_.kind != Destination::Kind::file || stat(to_.path.c_str(), &old) != 0) return;
  if (fstat(descriptor_, &anew) != 0) fail(errno);
  const bool is_owner_same = old.st_uid == anew.st_uid && old.st_gid == anew.st_gid;
  if (!is_owner_same && fchown(descriptor_, old.st_uid, old.st_gid) != 0)
    throw Error(fmt::format("{}: cannot be written anew for its owner (user {}, group {}): {}", to_.name,
                            old.st_uid, old.st_gid, std::strerror(errno)));
  if (fchmod(descriptor_, old.st_mode & 07777) != 0) fail(errno);
}

void OutputFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR) fail(errno);
    if (written > 0) bytes.remove_prefix(std::size_t(written));
  }
}

void OutputFile::close_flushed() {
  struct stat status {};
  if (fstat(descriptor_, &status) != 0) fail(errno);
  if (S_ISREG(status.st_mode) && fsync(descriptor_) != 0 && errno != EINVAL) fail(errno);
  if (close(std::exchange(descriptor_, -1)) != 0) fail(errno);
}

void OutputFile::take_place() {
  if (std::rename(temporary_.c_str(), to_.path.c_str()) != 0) fail(errno);
  temporary_.clear();
  flush_folder_of(to_.path);
}

void OutputFile::finish() {
  close_flushed();
  if (to_.kind == Destination::Kind::file) take_place();
}

void OutputFile::finish_beside(const std::string& old_name) {
  close_flushed();
  if (to_.kind != Destination::Kind::file) return;
  keep_as(to_.path, fs::path(to_.path).parent_path() / old_name);
  take_place();
}

int OutputFile::open_descriptor() const {
  if (to_.kind == Destination::Kind::descriptor) return fcntl(to_.descriptor, F_DUPFD_CLOEXEC, 0);
  if (to_.kind == Destination::Kind::special) return open(to_.path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
  unlink(temporary_.c_str());  // Left by an earlier process of the same number, if by any.
  return open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
}

void OutputFile::fail(int error) const {
  throw Error(fmt::format("{}: cannot be written: {}", to_.name, std::strerror(error)));
}

std::string temporary_path(const std::string& name) { return temporary_path_of(destination_of(name)); }

void check_outputs(const std::vector<std::string>& names) {
  std::unordered_map<std::string, std::string> places;  // With the name of what goes there.
  for (const std::string& name : names) {
    const Destination place = destination_of(name);
    for (const std::string& key : keys_of(place))
      if (const auto [other, is_new] = places.try_emplace(key, name); !is_new)
        throw Error(fmt::format("{}: the same place as {}; every output needs its own", name, other->second));
    check_output(place);
  }
}

void write_file(const std::string& name, std::string_view bytes) {
  OutputFile file(destination_of(name));
  file.take_mode_and_owner();
  file.write(bytes);
  file.finish();
}

}  // namespace twinray
