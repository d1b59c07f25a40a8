// SPDX-License-Identifier: Apache-2.0
#include "io/network/network_address.h"

#include <fmt/format.h>

#include <charconv>
#include <system_error>

#include "core/error.h"

namespace twinray {
namespace {

std::uint16_t parse_port(const std::string& word, const std::string& text, std::uint16_t least) {
  std::uint16_t port = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), port);
  if (error != std::errc{} || end != word.data() + word.size() || port < least)
    throw Error(fmt::format("\"{}\" is no port in \"{}\"; valid are {} to 65535", word, text, least));
  return port;
}

}  // namespace

NetworkAddress parse_address(const std::string& text, const NetworkAddress& usual, std::uint16_t least_port) {
  NetworkAddress address = usual;
  const std::size_t bracket = text.starts_with('[') ? text.find(']') : 0;
  if (bracket == text.npos) throw Error(fmt::format("\"{}\": the bracket is not closed", text));
  const std::size_t colon = text.find(':', bracket);
  const std::string host = bracket > 0 ? text.substr(1, bracket - 1) : text.substr(0, colon);
  if (bracket > 0 && colon != bracket + 1 && bracket + 1 != text.size())
    throw Error(fmt::format("\"{}\" is not HOST:PORT", text));
  if (!host.empty()) address.host = host;
  if (colon != text.npos) address.port = parse_port(text.substr(colon + 1), text, least_port);
  return address;
}

std::string host_text(const std::string& host) {
  return host.find(':') == std::string::npos ? host : fmt::format("[{}]", host);
}

std::string text_of(const NetworkAddress& address) {
  return fmt::format("{}:{}", host_text(address.host), address.port);
}

}  // namespace twinray
