// SPDX-License-Identifier: Apache-2.0
#include "io/picture/exr_streams.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

namespace twinray {

DiskInput::DiskInput(const std::string& path)
    : IStream(path.c_str()), descriptor_(open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
  struct stat status {};
  if (descriptor_ < 0 || fstat(descriptor_, &status) != 0) {
    const int fault = errno;
    if (descriptor_ >= 0) close(descriptor_);  // A constructor that throws has no destructor.
    throw Error(fmt::format("{}: cannot be read: {}", path, std::strerror(fault)));
  }
  size_ = std::uint64_t(status.st_size);
}

DiskInput::~DiskInput() { close(descriptor_); }

bool DiskInput::read(char* to, int count) {
  for (int done = 0; done < count;) {
    const ssize_t more = pread(descriptor_, to + done, std::size_t(count - done), off_t(at_) + done);
    if (more < 0 && errno == EINTR) continue;
    if (more < 0) throw Iex::InputExc(std::strerror(errno));
    if (more == 0) throw Iex::InputExc("it is cut off");
    done += int(more);
  }
  at_ += std::uint64_t(count);
  return at_ < size_;
}

}  // namespace twinray
