// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace twinray {

/// A file without a name, in the system's folder for temporary files (TMPDIR, else /tmp): it is gone with the
/// process, however that ends.
class ScratchFile {
 public:
  /// Throws Error where the folder takes no file.
  ScratchFile();
  ~ScratchFile();
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;

  std::uint64_t size() const { return size_; }
  /// By one thread. Throws Error where there is no room.
  void append(std::span<const std::byte> bytes);
  /// Any number of threads may. Throws Error where the bytes from this place on are not there.
  void read(std::uint64_t place, std::span<std::byte> bytes) const;

 private:
  std::string folder_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
};

}  // namespace twinray
