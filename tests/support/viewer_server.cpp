// SPDX-License-Identifier: Apache-2.0
#include "tests/support/viewer_server.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstring>
#include <stdexcept>

namespace twinray::test {
namespace {

/// A packet's bytes, taken one value after the other.
class Reader {
 public:
  explicit Reader(const std::string& bytes) : bytes_(bytes) {}
  template <class Number>
  Number number() {
    if (bytes_.size() - at_ < sizeof(Number)) throw std::runtime_error("a packet is too short");
    Number value;
    std::memcpy(&value, &bytes_[at_], sizeof(value));
    at_ += sizeof(value);
    return value;
  }
  std::string text() {
    const std::size_t end = bytes_.find('\0', at_);
    if (end == bytes_.npos) throw std::runtime_error("a text of a packet has no end");
    std::string word = bytes_.substr(at_, end - at_);
    at_ = end + 1;
    return word;
  }
  bool is_at_end() const { return at_ == bytes_.size(); }

 private:
  const std::string& bytes_;
  std::size_t at_ = 0;
};

sockaddr_in local_address() {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return address;
}

/// A socket that is bound to a free port, and the port.
std::pair<int, std::uint16_t> bound_socket() {
  const int bound = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address = local_address();
  socklen_t size = sizeof(address);
  const int small = 4096;  // a viewer that does not read is soon full
  setsockopt(bound, SOL_SOCKET, SO_RCVBUF, &small, sizeof(small));
  if (bind(bound, reinterpret_cast<sockaddr*>(&address), size) != 0 ||
      getsockname(bound, reinterpret_cast<sockaddr*>(&address), &size) != 0)
    throw std::runtime_error("no port is free");
  return {bound, ntohs(address.sin_port)};
}

/// So many bytes; fewer where the other side closes.
std::string receive(int connection, std::size_t count) {
  std::string bytes(count, '\0');
  std::size_t got = 0;
  while (got < count) {
    const ssize_t more = recv(connection, &bytes[got], count - got, 0);
    if (more <= 0) break;
    got += std::size_t(more);
  }
  bytes.resize(got);
  return bytes;
}

/// The bytes of the next packet; none at the end.
std::string receive_packet(int connection) {
  std::string bytes = receive(connection, 4);
  if (bytes.size() < 4) return "";
  std::uint32_t length;
  std::memcpy(&length, bytes.data(), 4);
  return bytes + receive(connection, length - 4);
}

}  // namespace

ViewerPacket read_packet(const std::string& bytes) {
  Reader reader(bytes);
  ViewerPacket packet{.bytes = bytes.size()};
  if (reader.number<std::uint32_t>() != bytes.size()) throw std::runtime_error("a packet has another length");
  packet.operation = reader.number<std::uint8_t>();
  if (reader.number<std::uint8_t>() != 0) throw std::runtime_error("a packet takes the focus");
  packet.name = reader.text();
  const bool creates = packet.operation == 4;
  if (creates) {
    packet.width = reader.number<std::int32_t>();
    packet.height = reader.number<std::int32_t>();
  }
  packet.channels.resize(std::size_t(reader.number<std::int32_t>()));
  for (std::string& channel : packet.channels) channel = reader.text();
  if (!creates) {
    for (int* value : {&packet.x, &packet.y, &packet.width, &packet.height})
      *value = reader.number<std::int32_t>();
    for (auto* list : {&packet.offsets, &packet.strides})
      for (std::size_t i = 0; i < packet.channels.size(); ++i) list->push_back(reader.number<std::int64_t>());
    while (!reader.is_at_end()) packet.values.push_back(reader.number<float>());
  }
  if (!reader.is_at_end()) throw std::runtime_error("a packet is too long");
  return packet;
}

ViewerServer::ViewerServer(Manner manner) : manner_(manner) {
  std::tie(listener_, port_) = bound_socket();
  if (listen(listener_, 4) != 0 || pipe(wake_) != 0) throw std::runtime_error("no viewer can listen");
  thread_ = std::thread([this] { run(); });
}

ViewerServer::~ViewerServer() {
  close(wake_[1]);
  thread_.join();
  for (const int connection : kept_) close(connection);
  close(listener_);
  close(wake_[0]);
}

void ViewerServer::run() {
  for (;;) {
    pollfd entries[]{{listener_, POLLIN, 0}, {wake_[0], POLLIN, 0}};
    poll(entries, 2, -1);
    if (entries[1].revents != 0) return;
    const int connection = accept(listener_, nullptr, nullptr);
    {
      const std::lock_guard lock(mutex_);
      ++connections_;
      changed_.notify_all();
    }
    if (manner_ == Manner::reads_nothing)
      kept_.push_back(connection);
    else
      read(connection);
  }
}

void ViewerServer::read(int connection) {
  for (;;) {
    const std::string bytes = receive_packet(connection);
    if (bytes.empty()) break;
    const std::lock_guard lock(mutex_);
    packets_.push_back(read_packet(bytes));
    if (manner_ == Manner::closes_after_a_packet) break;
  }
  close(connection);
  const std::lock_guard lock(mutex_);
  ++ended_;
  changed_.notify_all();
}

int ViewerServer::wait_for_connections(int count) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return connections_ >= count; });
  return connections_;
}

std::vector<ViewerPacket> ViewerServer::wait_for_end() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return connections_ > 0 && ended_ == connections_; });
  return packets_;
}

std::uint16_t free_port() {
  const auto [bound, port] = bound_socket();
  close(bound);
  return port;
}

}  // namespace twinray::test
