// SPDX-License-Identifier: Apache-2.0
#include "io/http/access.h"

#include <fmt/format.h>
#include <sys/random.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

namespace twinray::http {
namespace {

/// "localhost:8184" -> "localhost", "[::1]:8184" -> "[::1]".
std::string host_of(const std::string& field) {
  const std::size_t bracket = field.find(']');
  return field.substr(0, field.find(':', bracket == field.npos ? 0 : bracket));
}

bool is_host_of_this_machine(const std::string& host, const std::string& own) {
  return host == "localhost" || host == "127.0.0.1" || host == "[::1]" || host == host_text(own);
}

/// What other machines call this one where it listens at all its addresses.
std::string name_for_others(const std::string& host) {
  if (host != "0.0.0.0" && host != "::") return host;
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : host;
}

}  // namespace

std::string random_token() {
  std::array<unsigned char, 16> bytes;
  if (getentropy(bytes.data(), bytes.size()) != 0) throw Error(std::strerror(errno));
  std::string token;
  for (const unsigned char byte : bytes) token += fmt::format("{:02x}", byte);
  return token;
}

bool are_equal_secrets(const std::string& a, const std::string& b) {
  if (a.size() != b.size()) return false;
  unsigned char differences = 0;
  for (std::size_t i = 0; i < a.size(); ++i) differences |= static_cast<unsigned char>(a[i] ^ b[i]);
  return differences == 0;
}

Access::Access(const NetworkAddress& address, std::string token)
    : address_(address), token_(std::move(token)) {}

Access Access::of(const TcpListener& listener) {
  return {listener.address(), listener.is_local() ? "" : random_token()};
}

std::string Access::page_address() const {
  const std::string place = text_of({name_for_others(address_.host), address_.port});
  return fmt::format("http://{}/{}", place, token_.empty() ? "" : "?token=" + token_);
}

void Access::check(const Request& request) const {
  const std::string& host = request.field("host");
  const auto token = request.query.find("token");
  if (token_.empty()) {
    if (!is_host_of_this_machine(host_of(host), address_.host))
      throw Refusal(403, fmt::format("This server is asked as http://{}/ alone.", text_of(address_)));
  } else if (token == request.query.end() || !are_equal_secrets(token->second, token_)) {
    throw Refusal(403, "The token is missing or wrong: the program prints the address with it.");
  }
  if (request.method == "POST" && request.field("origin") != "http://" + host)
    throw Refusal(403, "Only a page of this server may do that: the field Origin says which one asks.");
}

}  // namespace twinray::http
