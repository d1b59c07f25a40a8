// SPDX-License-Identifier: Apache-2.0
// Private: where OpenEXR reads and writes. Each throws Iex::InputExc where a file has no such bytes.
#pragma once
#include <Iex.h>
#include <ImfIO.h>

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "io/picture/picture_bytes.h"

namespace twinray {

/// OpenEXR would divide each file among threads of its own.
inline constexpr int no_threads = 0;

/// A file in memory.
class MemoryInput final : public Imf::IStream {
 public:
  explicit MemoryInput(const PictureBytes& picture) : IStream(picture.path.c_str()), bytes_(picture.bytes) {}

  bool read(char* to, int count) override {
    if (count < 0 || at_ > bytes_.size() || std::size_t(count) > bytes_.size() - at_)
      throw Iex::InputExc("it is cut off");
    std::memcpy(to, bytes_.data() + at_, std::size_t(count));
    at_ += std::size_t(count);
    return at_ < bytes_.size();
  }
  std::uint64_t tellg() override { return at_; }
  void seekg(std::uint64_t at) override { at_ = at; }

 private:
  std::string_view bytes_;
  std::uint64_t at_ = 0;
};

/// A file on disk, of which only what is asked for is read.
class DiskInput final : public Imf::IStream {
 public:
  /// Throws Error where it cannot be opened.
  explicit DiskInput(const std::string& path);
  ~DiskInput() override;

  bool read(char* to, int count) override;
  std::uint64_t tellg() override { return at_; }
  void seekg(std::uint64_t at) override { at_ = at; }

 private:
  int descriptor_;
  std::uint64_t at_ = 0, size_ = 0;
};

/// A file that is put together in memory: a pipe cannot be written in any other order.
class MemoryOutput final : public Imf::OStream {
 public:
  explicit MemoryOutput(std::vector<unsigned char>& bytes) : OStream("memory"), bytes_(bytes) {}

  void write(const char* from, int count) override {
    const std::size_t end = at_ + std::size_t(count);
    if (end > bytes_.size()) bytes_.resize(end);
    std::memcpy(bytes_.data() + at_, from, std::size_t(count));
    at_ = end;
  }
  std::uint64_t tellp() override { return at_; }
  void seekp(std::uint64_t at) override { at_ = at; }

 private:
  std::vector<unsigned char>& bytes_;
  std::uint64_t at_ = 0;
};

}  // namespace twinray
