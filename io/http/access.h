// SPDX-License-Identifier: Apache-2.0
// Who may ask a server, and what for.
#pragma once
#include <string>

#include "io/http/message.h"
#include "io/network/network_address.h"
#include "io/network/tcp_listener.h"

namespace twinray::http {

/// A secret of 128 random bits in hexadecimal digits, from the operating system. Throws Error.
std::string random_token();

/// Whether two texts are equal, in a time that depends on their lengths alone.
bool are_equal_secrets(const std::string& a, const std::string& b);

/// The rules. Whoever can reach the server through this machine alone needs no secret, but must name a host
/// of this machine: else any page of the net could ask through a name of its own that leads here (DNS
/// rebinding). From elsewhere each request needs a token. What changes something must come from a page of the
/// server itself: it is asked for by POST. No page answers to other methods than that and GET.
class Access {
 public:
  /// `token` is empty where none is needed.
  Access(const NetworkAddress& address, std::string token);
  /// Those of a server that listens there, with a new token where it needs one.
  static Access of(const TcpListener& listener);

  /// Where people find the page: "http://127.0.0.1:8184/", with the token behind it where there is one.
  std::string page_address() const;
  /// Throws Refusal.
  void check(const Request& request) const;

 private:
  NetworkAddress address_;
  std::string token_;
};

}  // namespace twinray::http
