// SPDX-License-Identifier: Apache-2.0
// Files that are whole or not there: written beside their place, every byte checked, then renamed. What is no
// regular file (a device, a FIFO, standard output) is written into instead. "-" is standard output.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "io/destination.h"

namespace twinray {

/// An output that is open: begun, written, finished. Unless it is finished, nothing of it stays. Each
/// function throws Error with the reason where a byte cannot be written.
class OutputFile {
 public:
  explicit OutputFile(const std::string& name) : OutputFile(destination_of(name)) {}
  explicit OutputFile(Destination to);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Takes the mode and the owner of an old file that it is to replace.
  void take_mode_and_owner() const;
  void write(std::string_view bytes);
  /// Flushes, closes and moves the file to its place.
  void finish();
  /// The same, and an old file stays, by this name in its folder.
  void finish_beside(const std::string& old_name);

 private:
  int open_descriptor() const;
  void close_flushed();
  void take_place();
  [[noreturn]] void fail(int error) const;

  Destination to_;
  std::string temporary_;  ///< Empty for what is written into, and once there is nothing to remove.
  int descriptor_;
};

/// Where a file is while it is being written: a hidden name in its own folder, of this process alone; empty
/// for what is written into. Throws Error where destination_of does.
std::string temporary_path(const std::string& name);

/// Throws Error unless all these outputs could be written: the folder must exist and be writable, a name must
/// not be a folder's, an old file must be writable and of an owner that can be kept, and no two names may
/// stand for the same place. Nothing is left behind.
void check_outputs(const std::vector<std::string>& names);

/// Writes the bytes and nothing else. A regular file is replaced as a whole, with the mode and owner of the
/// old one, which survives any failure; links are followed. Throws Error with the reason where a byte cannot
/// be written.
void write_file(const std::string& name, std::string_view bytes);

}  // namespace twinray
