// SPDX-License-Identifier: Apache-2.0
#include "io/destination.h"

#include <fmt/format.h>
#include <limits.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <optional>

#include "core/error.h"

namespace twinray {
namespace {

namespace fs = std::filesystem;

constexpr int most_links = 40;  // as Linux follows

[[noreturn]] void fail(const std::string& name, int error) {
  if (error == ELOOP) throw Error(fmt::format("{}: a link that leads back to itself", name));
  if (error == ENAMETOOLONG)
    throw Error(fmt::format("{}: the name is too long; valid are up to {} bytes, and {} with its folders",
                            name, NAME_MAX, PATH_MAX - 1));
  throw Error(fmt::format("{}: cannot be written: {}", name, std::strerror(error)));
}

fs::path folder_of(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : "."; }

/// The status of what a path names itself; nothing where it names nothing.
std::optional<struct stat> status_of(const std::string& name, const fs::path& path) {
  struct stat status {};
  if (lstat(path.c_str(), &status) == 0) return status;
  if (errno == ENOENT) return std::nullopt;
  fail(name, errno);
}

/// The number of an open descriptor of this process that a path in /proc stands for.
std::optional<int> descriptor_at(const fs::path& path) {
  std::error_code ignored;
  if (fs::canonical(folder_of(path), ignored) != fmt::format("/proc/{}/fd", getpid())) return std::nullopt;
  const std::string number = path.filename().string();
  int descriptor = -1;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), descriptor);
  if (error != std::errc{} || end != number.data() + number.size()) return std::nullopt;
  return descriptor;
}

void check_folder(const std::string& name, const fs::path& path) {
  struct stat status {};
  const fs::path folder = folder_of(path);
  const bool is_there = stat(folder.c_str(), &status) == 0;
  if (!is_there && errno != ENOENT && errno != ENOTDIR) fail(name, errno);
  if (!is_there || !S_ISDIR(status.st_mode))
    throw Error(fmt::format("{}: there is no folder {}", name, folder.string()));
}

Destination kind_of(Destination destination, const std::optional<struct stat>& status) {
  if (status && S_ISDIR(status->st_mode))
    throw Error(fmt::format("{}: cannot be written: it is a folder", destination.name));
  destination.kind =
      status && !S_ISREG(status->st_mode) ? Destination::Kind::special : Destination::Kind::file;
  return destination;
}

/// The status of what is there now; nothing where there is nothing.
std::optional<struct stat> present(const Destination& destination) {
  struct stat status {};
  const int result = destination.kind == Destination::Kind::descriptor
                         ? fstat(destination.descriptor, &status)
                         : stat(destination.path.c_str(), &status);
  return result == 0 ? std::optional(status) : std::nullopt;
}

/// The one path of a file that is not there yet.
fs::path place_of_new(const Destination& destination) {
  const fs::path path(destination.path);
  std::error_code ignored;
  return fs::canonical(folder_of(path), ignored) / path.filename();
}

}  // namespace

Destination destination_of(const std::string& name) {
  if (name == "-") return {Destination::Kind::descriptor, name, "", STDOUT_FILENO};
  fs::path path = name;
  for (int links = 0; links <= most_links; ++links) {
    check_folder(name, path);
    if (const std::optional<int> descriptor = descriptor_at(path))
      return {Destination::Kind::descriptor, name, "", *descriptor};
    const std::optional<struct stat> status = status_of(name, path);
    if (!status || !S_ISLNK(status->st_mode))
      return kind_of({Destination::Kind::file, name, path.string(), -1}, status);
    std::error_code error;
    path = folder_of(path) / fs::read_symlink(path, error);
    if (error) fail(name, error.value());
  }
  fail(name, ELOOP);
}

bool is_standard_output(const std::string& name) { return destination_of(name).descriptor == STDOUT_FILENO; }

std::vector<std::string> keys_of(const Destination& destination) {
  std::vector<std::string> keys;
  if (destination.descriptor >= 0) keys.push_back(fmt::format("descriptor {}", destination.descriptor));
  const std::optional<struct stat> there = present(destination);
  if (!there && destination.descriptor < 0)
    keys.push_back("new " + place_of_new(destination).string());
  else if (there && !S_ISCHR(there->st_mode))
    keys.push_back(fmt::format("file {} {}", there->st_dev, there->st_ino));
  return keys;
}

bool is_same_place(const Destination& a, const Destination& b) {
  const std::vector<std::string> of_a = keys_of(a), of_b = keys_of(b);
  return std::find_first_of(of_a.begin(), of_a.end(), of_b.begin(), of_b.end()) != of_a.end();
}

}  // namespace twinray
