// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <string>

namespace twinray {

/// Where a program listens.
struct NetworkAddress {
  std::string host = "127.0.0.1";
  std::uint16_t port = 0;  ///< 0, where something is to be chosen: any free one.
};

/// "HOST", "HOST:PORT", ":PORT" or "[IPv6 ADDRESS]:PORT"; what is left out is as in `usual`. Throws Error,
/// which says what would be valid, also for a port below `least_port`.
NetworkAddress parse_address(const std::string& text, const NetworkAddress& usual, std::uint16_t least_port);

/// "HOST:PORT" or "[IPv6 ADDRESS]:PORT".
std::string text_of(const NetworkAddress& address);

/// The host as it stands before the port: an IPv6 address in brackets.
std::string host_text(const std::string& host);

}  // namespace twinray
