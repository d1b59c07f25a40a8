// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace twinray {

/// A NanoVDB file (.nvdb): grids one behind the other, each as it lies in memory, packed or not. Its layout
/// is that of nanovdb/util/IO.h, of version 32.
class NvdbFile {
 public:
  /// `bytes` are the file's, and must outlive this; `name` stands for it in messages. Throws Error where it
  /// is none, or not of this version.
  NvdbFile(std::string_view bytes, const std::string& name);

  const std::string& name() const { return name_; }
  /// Of its grids.
  std::vector<std::string_view> grid_names() const;
  bool has(std::string_view grid) const { return find(grid) != nullptr; }
  /// The bytes of the first grid of this name, unpacked; a multiple of eight. Throws Error where there is
  /// none, or its bytes are damaged, or become more than max_input_bytes.
  std::vector<std::uint64_t> grid(std::string_view grid) const;

 private:
  enum class Codec : std::uint16_t { none, zip, blosc };
  struct Entry {
    std::string_view name, packed;
    std::uint64_t size = 0;  ///< Unpacked.
    Codec codec = Codec::none;
  };
  const Entry* find(std::string_view grid) const;

  std::string name_;
  std::vector<Entry> entries_;
};

}  // namespace twinray
