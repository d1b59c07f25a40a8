// SPDX-License-Identifier: Apache-2.0
// Files of one test.
#pragma once
#include <filesystem>
#include <string>

namespace twinray::test {

/// A folder for one test's files, empty at first and removed at its end.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string file(const std::string& name) const { return (path_ / name).string(); }
  const std::filesystem::path& path() const { return path_; }
  /// Names of all files in it, those that begin with a dot included.
  std::size_t file_count() const;

 private:
  std::filesystem::path path_;
};

std::string read_text(const std::string& path);
void write_text(const std::string& path, const std::string& text);

}  // namespace twinray::test
