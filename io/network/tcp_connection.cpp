// SPDX-License-Identifier: Apache-2.0
#include "io/network/tcp_connection.h"

#include <fcntl.h>
#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>

#include <cerrno>
#include <chrono>
#include <cstring>

#include "core/error.h"

namespace twinray {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int wait_milliseconds = 20;
constexpr std::chrono::seconds connect_limit{2};

/// Whether the socket takes bytes, after a moment at most.
bool is_writable(int socket) {
  pollfd entry{socket, POLLOUT, 0};
  return poll(&entry, 1, wait_milliseconds) > 0;
}

/// The system's error of a connection that was begun; 0 where it stands.
int finish_connecting(int socket, const TcpConnection::GivesUp& gives_up) {
  const Clock::time_point end = Clock::now() + connect_limit;
  while (!is_writable(socket))
    if (gives_up() || Clock::now() > end) return ETIMEDOUT;
  int error = 0;
  socklen_t size = sizeof(error);
  return getsockopt(socket, SOL_SOCKET, SO_ERROR, &error, &size) == 0 ? error : errno;
}

/// The system's error; 0 where the connection stands.
int connect_to(int socket, const addrinfo& address, const TcpConnection::GivesUp& gives_up) {
  if (fcntl(socket, F_SETFL, O_NONBLOCK) < 0) return errno;
  if (connect(socket, address.ai_addr, address.ai_addrlen) == 0) return 0;
  return errno == EINPROGRESS ? finish_connecting(socket, gives_up) : errno;
}

}  // namespace

TcpConnection::TcpConnection(const std::string& host, std::uint16_t port, const GivesUp& gives_up) {
  const SocketAddresses all = socket_addresses(host, port);
  int error = 0;
  for (const addrinfo* one = all.get(); one && !is_open(); one = one->ai_next) {
    socket_ = Socket(socket(one->ai_family, one->ai_socktype | SOCK_CLOEXEC, one->ai_protocol));
    error = is_open() ? connect_to(socket_.descriptor(), *one, gives_up) : errno;
    if (error != 0) socket_ = Socket();
  }
  if (!is_open()) throw Error(std::strerror(error));
}

bool TcpConnection::send(std::string_view bytes, const GivesUp& gives_up) {
  while (!bytes.empty()) {
    if (gives_up()) return false;
    if (!is_writable(socket_.descriptor())) continue;
    const ssize_t sent = ::send(socket_.descriptor(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent >= 0)
      bytes.remove_prefix(std::size_t(sent));
    else if (errno != EAGAIN && errno != EINTR)
      throw Error(std::strerror(errno));
  }
  return true;
}

bool TcpConnection::is_closed_by_peer() const {
  char byte;
  const ssize_t received = recv(socket_.descriptor(), &byte, 1, MSG_PEEK | MSG_DONTWAIT);
  return received == 0 || (received < 0 && errno != EAGAIN && errno != EINTR);
}

}  // namespace twinray
