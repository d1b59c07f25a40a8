// SPDX-License-Identifier: Apache-2.0
// A server of HTTP for a few readers beside which other work goes on: one thread, which never waits for
// anybody, for sockets that do not block. So nobody who is slow, silent or numerous holds up anybody else,
// nor the end of the program.
#pragma once
#include <thread>
#include <vector>

#include "io/http/connection.h"
#include "io/network/socket.h"
#include "io/network/tcp_listener.h"

namespace twinray::http {

class Server {
 public:
  /// So many connections at once, and so many bytes that are kept for them; beyond that the oldest ones end.
  static constexpr std::size_t most_connections = 64, most_kept_bytes = std::size_t(512) << 20;

  /// Answers from now on; the handler is called by the server's thread alone. Throws Error where there can be
  /// no thread.
  Server(TcpListener listener, Handler handler);
  /// Ends at once, with all connections.
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

 private:
  void run();
  /// Waits for what comes next; false at the end.
  bool wait();
  void serve();
  void accept();
  void make_room();

  TcpListener listener_;
  Handler handler_;
  Socket wake_, woken_;                  ///< Two ends: the thread ends when the first one closes.
  std::vector<Connection> connections_;  ///< From the oldest one.
  std::vector<short> ready_;             ///< What poll() said of each; then of the listener.
  bool is_full_ = false;                 ///< The system has no descriptor left: no connection is taken.
  std::thread thread_;
};

}  // namespace twinray::http
