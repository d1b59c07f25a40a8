// SPDX-License-Identifier: Apache-2.0
// Files that are whole or not there: written beside their place, then renamed.
#pragma once
#include <string>

namespace twinray {

/// Where a file is while it is being written: a hidden name in its own folder, of this process alone.
std::string temporary_path(const std::string& path);

/// Throws Error unless a file of this name could be written: the folder must exist and be writable, the name
/// must not be a folder's. Nothing is left behind.
void check_output(const std::string& path);

/// An output that is being written at path(); unless it is finished it is removed again, and an older file of
/// the target's name survives.
class OutputFile {
 public:
  explicit OutputFile(std::string target) : target_(std::move(target)), path_(temporary_path(target_)) {}
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  const std::string& path() const { return path_; }
  /// Moves the file to its place. Throws Error where that fails.
  void finish();

 private:
  std::string target_, path_;
};

/// Writes a whole text. Throws Error.
void write_text_file(const std::string& path, const std::string& text);

}  // namespace twinray
