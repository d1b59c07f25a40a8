// SPDX-License-Identifier: Apache-2.0
#include "io/network/socket.h"

#include <netdb.h>
#include <sys/socket.h>
#include <unistd.h>

#include "core/error.h"

namespace twinray {

Socket::~Socket() {
  if (is_open()) close(descriptor_);
}

SocketAddresses socket_addresses(const std::string& host, unsigned port) {
  addrinfo hints{};
  hints.ai_family = AF_UNSPEC;
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  const int error = getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &found);
  if (error != 0) throw Error(gai_strerror(error));
  return {found, freeaddrinfo};
}

}  // namespace twinray
