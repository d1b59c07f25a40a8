// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "io/network/network_address.h"
#include "io/network/socket.h"

namespace twinray {

/// A TCP port where programs may connect to this one.
class TcpListener {
 public:
  /// Listens at the first of the host's addresses that can be had; port 0 is any free one. Throws Error with
  /// the system's reason.
  explicit TcpListener(const NetworkAddress& address);

  /// With the port that it has.
  const NetworkAddress& address() const { return address_; }
  /// Whether programs of this machine alone can reach it.
  bool is_local() const { return is_local_; }
  int descriptor() const { return socket_.descriptor(); }
  /// The next program that connects, over a socket that never blocks; none where nobody waits, or where the
  /// system has no descriptor left.
  Socket accept() const;

 private:
  NetworkAddress address_;
  Socket socket_;
  bool is_local_ = false;
};

}  // namespace twinray
