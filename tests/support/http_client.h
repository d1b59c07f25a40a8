// SPDX-License-Identifier: Apache-2.0
// A client of HTTP for tests, a polite one and a rude one.
#pragma once
#include <cstdint>
#include <string>

#include "io/network/socket.h"

namespace twinray::test {

/// An answer, in its parts.
struct HttpAnswer {
  int status = 0;  ///< 0: there was none.
  std::string head, body;

  /// A field's value; empty where there is none.
  std::string field(const std::string& name) const;
};

/// A connection to a port of this machine that does only what it is told. Throws std::runtime_error where
/// nobody listens.
class HttpClient {
 public:
  /// With a buffer that is soon full where `receive_buffer` is small; 0: the system's.
  explicit HttpClient(std::uint16_t port, int receive_buffer = 0);
  /// As much as the other side takes.
  void send(const std::string& text);
  /// So many bytes; fewer where the other side closes.
  std::string receive(std::size_t count);
  /// All that comes until the other side closes.
  HttpAnswer answer();

 private:
  Socket socket_;
};

/// Asks with this method for this target ("/state?a=b"), as a page of the server would; `fields` are further
/// lines, each with its end.
HttpAnswer ask(std::uint16_t port, const std::string& method, const std::string& target,
               const std::string& fields = "");
inline HttpAnswer get(std::uint16_t port, const std::string& target) { return ask(port, "GET", target); }

}  // namespace twinray::test
