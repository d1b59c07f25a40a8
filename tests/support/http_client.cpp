// SPDX-License-Identifier: Apache-2.0
#include "tests/support/http_client.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>

namespace twinray::test {

std::string HttpAnswer::field(const std::string& name) const {
  const std::size_t begin = head.find("\r\n" + name + ": ");
  if (begin == head.npos) return "";
  const std::size_t value = begin + name.size() + 4;
  return head.substr(value, head.find("\r\n", value) - value);
}

HttpClient::HttpClient(std::uint16_t port, int receive_buffer)
    : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
  if (receive_buffer > 0)
    setsockopt(socket_.descriptor(), SOL_SOCKET, SO_RCVBUF, &receive_buffer, sizeof(receive_buffer));
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (connect(socket_.descriptor(), reinterpret_cast<sockaddr*>(&address), sizeof(address)) != 0)
    throw std::runtime_error("nobody listens at that port");
}

void HttpClient::send(const std::string& text) {
  std::size_t sent = 0;
  while (sent < text.size()) {
    const ssize_t more = ::send(socket_.descriptor(), text.data() + sent, text.size() - sent, MSG_NOSIGNAL);
    if (more <= 0) return;
    sent += std::size_t(more);
  }
}

std::string HttpClient::receive(std::size_t count) {
  std::string all;
  std::array<char, 65536> bytes;
  while (all.size() < count) {
    const ssize_t more =
        recv(socket_.descriptor(), bytes.data(), std::min(bytes.size(), count - all.size()), 0);
    if (more <= 0) break;
    all.append(bytes.data(), std::size_t(more));
  }
  return all;
}

HttpAnswer HttpClient::answer() {
  const std::string all = receive(std::numeric_limits<std::size_t>::max());
  const std::size_t end = all.find("\r\n\r\n");
  if (!all.starts_with("HTTP/1.1 ") || end == all.npos) return {};
  return {std::stoi(all.substr(9, 3)), all.substr(0, end + 2), all.substr(end + 4)};
}

HttpAnswer ask(std::uint16_t port, const std::string& method, const std::string& target,
               const std::string& fields) {
  HttpClient client(port);
  client.send(fmt::format("{} {} HTTP/1.1\r\nHost: localhost:{}\r\nOrigin: http://localhost:{}\r\n{}\r\n",
                          method, target, port, port, fields));
  return client.answer();
}

}  // namespace twinray::test
