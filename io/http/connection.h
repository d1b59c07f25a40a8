// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "io/http/message.h"
#include "io/network/socket.h"

namespace twinray::http {

using Clock = std::chrono::steady_clock;

/// Answers a request; throws Refusal where it cannot.
using Handler = std::function<Response(const Request&)>;

/// One request and its response. Nothing here waits: whoever owns the connection asks poll() for what it is
/// waiting for.
class Connection {
 public:
  /// Over a socket that does not block.
  explicit Connection(Socket socket);

  int descriptor() const { return socket_.descriptor(); }
  /// What poll() is to wait for.
  short events() const;
  /// Until then it must have gone on, else it is over: a request that does not end, a reader that does not
  /// read.
  Clock::time_point deadline() const { return deadline_; }
  bool is_over() const { return phase_ == Phase::over; }
  /// Bytes of a response that are kept for it.
  std::size_t kept_bytes() const { return body_ ? body_->size() : 0; }

  /// Goes on as far as it can without waiting, once poll() says so.
  void advance(const Handler& handler);

 private:
  enum class Phase { reading, writing, closing, over };
  void read(const Handler& handler);
  void respond(const Response& response);
  void write();
  void close();
  /// The bytes that are to be sent next; none at the end.
  std::string_view unsent() const;

  Socket socket_;
  Phase phase_ = Phase::reading;
  Clock::time_point deadline_;
  std::string request_, head_;
  std::shared_ptr<const std::string> body_;
  std::size_t sent_ = 0;  ///< Of head and body.
};

}  // namespace twinray::http
