// SPDX-License-Identifier: Apache-2.0
// The one door to libzip: reads the files of a zip archive.
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

struct zip;

namespace twinray {

class ZipArchive {
 public:
  /// Throws Error where there is no such file, or it is no zip archive.
  explicit ZipArchive(const std::string& path);

  const std::string& path() const { return path_; }
  /// The names of all entries, folders included, in the archive's order.
  std::vector<std::string> names() const;
  bool has(const std::string& name) const;
  /// The bytes of a file. Throws Error where there is none of this name, it is damaged or encrypted, and
  /// before anything is unpacked where it says that it becomes larger than max_bytes, or larger than
  /// small_bytes and more than most_growth times what it takes in the archive.
  std::string read(const std::string& name) const;

  static constexpr std::uint64_t max_bytes = std::uint64_t(1) << 30, small_bytes = std::uint64_t(1) << 26,
                                 most_growth = 100;

 private:
  struct Close {
    void operator()(zip* archive) const;
  };
  [[noreturn]] void fail(const std::string& name, const std::string& message) const;
  void check_size(const std::string& name, std::uint64_t size, std::uint64_t packed) const;

  std::string path_;
  std::unique_ptr<zip, Close> archive_;
};

}  // namespace twinray
