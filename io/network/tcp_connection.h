// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "io/network/socket.h"

namespace twinray {

/// A TCP connection over which bytes are sent, by POSIX sockets that never block for long: each wait asks
/// many times a second whether to give up.
class TcpConnection {
 public:
  using GivesUp = std::function<bool()>;

  TcpConnection() = default;
  /// Connects to one of the host's addresses, two seconds each at most. Throws Error with the system's
  /// reason.
  TcpConnection(const std::string& host, std::uint16_t port, const GivesUp& gives_up);

  bool is_open() const { return socket_.is_open(); }
  /// Sends all bytes, or throws Error. False where it gave up with some of them left.
  bool send(std::string_view bytes, const GivesUp& gives_up);
  /// Whether the other side has closed the connection.
  bool is_closed_by_peer() const;

 private:
  Socket socket_;
};

}  // namespace twinray
