// SPDX-License-Identifier: Apache-2.0
#include "io/network/tcp_listener.h"

#include <netdb.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstring>

#include "core/error.h"

namespace twinray {
namespace {

constexpr int backlog = 64;

/// The system's error; 0 where it listens.
int listen_at(int socket, const addrinfo& address) {
  const int on = 1;
  setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &on, sizeof(on));  // after a program that has just ended
  const bool listens = bind(socket, address.ai_addr, address.ai_addrlen) == 0 && listen(socket, backlog) == 0;
  return listens ? 0 : errno;
}

sockaddr_storage own_address(int socket) {
  sockaddr_storage address{};
  socklen_t size = sizeof(address);
  getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size);
  return address;
}

std::uint16_t port_of(const sockaddr_storage& address) {
  return ntohs(address.ss_family == AF_INET6 ? reinterpret_cast<const sockaddr_in6&>(address).sin6_port
                                             : reinterpret_cast<const sockaddr_in&>(address).sin_port);
}

bool is_loopback(const sockaddr_storage& address) {
  if (address.ss_family == AF_INET6)
    return IN6_IS_ADDR_LOOPBACK(&reinterpret_cast<const sockaddr_in6&>(address).sin6_addr);
  return ntohl(reinterpret_cast<const sockaddr_in&>(address).sin_addr.s_addr) >> 24 == 127;
}

}  // namespace

TcpListener::TcpListener(const NetworkAddress& address) : address_(address) {
  const SocketAddresses all = socket_addresses(address.host, address.port);
  int error = 0;
  for (const addrinfo* one = all.get(); one && !socket_.is_open(); one = one->ai_next) {
    socket_ = Socket(socket(one->ai_family, one->ai_socktype | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
    error = socket_.is_open() ? listen_at(socket_.descriptor(), *one) : errno;
    if (error != 0) socket_ = Socket();
  }
  if (!socket_.is_open()) throw Error(std::strerror(error));
  const sockaddr_storage own = own_address(socket_.descriptor());
  address_.port = port_of(own);
  is_local_ = is_loopback(own);
}

Socket TcpListener::accept() const {
  return Socket(accept4(socket_.descriptor(), nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK));
}

}  // namespace twinray
