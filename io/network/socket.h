// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>
#include <string>
#include <utility>

struct addrinfo;

namespace twinray {

/// A descriptor of the system's that is closed with its owner; -1 where there is none.
class Socket {
 public:
  Socket() = default;
  explicit Socket(int descriptor) : descriptor_(descriptor) {}
  ~Socket();
  Socket(Socket&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
  Socket& operator=(Socket&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    return *this;
  }

  bool is_open() const { return descriptor_ >= 0; }
  int descriptor() const { return descriptor_; }

 private:
  int descriptor_ = -1;
};

using SocketAddresses = std::unique_ptr<addrinfo, void (*)(addrinfo*)>;

/// The addresses of a host for TCP, at least one: a list. Throws Error with the system's reason.
SocketAddresses socket_addresses(const std::string& host, unsigned port);

}  // namespace twinray
