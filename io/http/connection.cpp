// SPDX-License-Identifier: Apache-2.0
#include "io/http/connection.h"

#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <utility>

namespace twinray::http {
namespace {

constexpr std::chrono::seconds request_limit{5}, stall_limit{10}, close_limit{1};
/// How much is sent before other connections have their turn.
constexpr std::size_t most_at_once = 1 << 20;

bool is_later(ssize_t count) { return count < 0 && (errno == EAGAIN || errno == EINTR); }

std::string_view part_from(std::string_view bytes, std::size_t begin) {
  return bytes.substr(begin, most_at_once);
}

/// `is_head` becomes true where the response is to go without its body: what GET would answer counts.
Response answer(const std::string& text, const Handler& handler, bool& is_head) {
  try {
    Request request = parse_request(text);
    is_head = request.method == "HEAD";
    if (is_head) request.method = "GET";
    return handler(request);
  } catch (const Refusal& refusal) {
    return text_response(refusal.status(), refusal.what());
  } catch (const std::exception& error) {
    return text_response(500, error.what());
  }
}

}  // namespace

Connection::Connection(Socket socket) : socket_(std::move(socket)), deadline_(Clock::now() + request_limit) {}

short Connection::events() const { return phase_ == Phase::writing ? POLLOUT : POLLIN; }

void Connection::advance(const Handler& handler) {
  if (phase_ == Phase::reading) read(handler);
  if (phase_ == Phase::writing) write();
  if (phase_ == Phase::closing) close();
}

void Connection::read(const Handler& handler) {
  std::array<char, 4096> bytes;
  const ssize_t count = recv(descriptor(), bytes.data(), bytes.size(), 0);
  if (is_later(count)) return;
  if (count <= 0) {
    phase_ = Phase::over;
    return;
  }
  request_.append(bytes.data(), std::size_t(count));
  const std::size_t end = std::min(request_.find("\r\n\r\n"), request_.size());
  if (end > most_request_bytes) {
    const bool is_long_address = request_.find("\r\n") > most_request_bytes;
    respond(text_response(is_long_address ? 414 : 431, "A request has 8192 bytes at most."));
  } else if (end < request_.size()) {
    bool is_head = false;
    respond(answer(request_.substr(0, end), handler, is_head));
    if (is_head) body_ = nullptr;
  }
}

void Connection::respond(const Response& response) {
  head_ = head_of(response);
  body_ = response.body;
  phase_ = Phase::writing;
  deadline_ = Clock::now() + stall_limit;
}

std::string_view Connection::unsent() const {
  if (sent_ < head_.size()) return part_from(head_, sent_);
  return body_ ? part_from(*body_, sent_ - head_.size()) : std::string_view();
}

void Connection::write() {
  const std::string_view bytes = unsent();
  const ssize_t count = send(descriptor(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
  if (is_later(count)) return;
  if (count < 0) {
    phase_ = Phase::over;
    return;
  }
  sent_ += std::size_t(count);
  deadline_ = Clock::now() + stall_limit;
  if (!unsent().empty()) return;
  // What the other side still sends is read: else its system might drop the response.
  body_ = nullptr;
  shutdown(descriptor(), SHUT_WR);
  phase_ = Phase::closing;
  deadline_ = Clock::now() + close_limit;
}

void Connection::close() {
  std::array<char, 4096> bytes;
  const ssize_t count = recv(descriptor(), bytes.data(), bytes.size(), 0);
  if (count <= 0 && !is_later(count)) phase_ = Phase::over;
}

}  // namespace twinray::http
