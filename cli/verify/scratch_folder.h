// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <string>

namespace twinray {

/// A folder for temporary files, in that of the system (TMPDIR, else /tmp), as long as this lives.
class ScratchFolder {
 public:
  /// Throws Error where none can be made.
  ScratchFolder();
  /// Removes it with all that is in it, as far as the process still may.
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  std::string path() const { return path_.string(); }
  std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

}  // namespace twinray
