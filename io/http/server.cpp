// SPDX-License-Identifier: Apache-2.0
#include "io/http/server.h"

#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "core/error.h"

namespace twinray::http {
namespace {

/// After that deadlines are looked at, and whether there are descriptors again.
constexpr int longest_wait_milliseconds = 250;

}  // namespace

Server::Server(TcpListener listener, Handler handler)
    : listener_(std::move(listener)), handler_(std::move(handler)) {
  std::array<int, 2> ends;
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) throw Error(std::strerror(errno));
  wake_ = Socket(ends[0]);
  woken_ = Socket(ends[1]);
  try {
    thread_ = std::thread([this] { run(); });
  } catch (const std::system_error& error) {
    throw Error(error.what());
  }
}

Server::~Server() {
  wake_ = Socket();
  thread_.join();
}

void Server::run() {
  while (wait()) {
    try {
      serve();
    } catch (const std::exception&) {  // There is no memory left.
      connections_.clear();
    }
  }
}

bool Server::wait() {
  std::vector<pollfd> entries;
  for (const Connection& connection : connections_)
    entries.push_back({connection.descriptor(), connection.events(), 0});
  entries.push_back({is_full_ ? -1 : listener_.descriptor(), POLLIN, 0});
  entries.push_back({woken_.descriptor(), POLLIN, 0});
  if (poll(entries.data(), entries.size(), longest_wait_milliseconds) < 0)
    for (pollfd& entry : entries) entry.revents = 0;
  ready_.clear();
  for (const pollfd& entry : entries) ready_.push_back(entry.revents);
  return entries.back().revents == 0;
}

void Server::serve() {
  const Clock::time_point now = Clock::now();
  for (std::size_t i = 0; i < connections_.size(); ++i)
    if (ready_[i] != 0) connections_[i].advance(handler_);
  std::erase_if(connections_, [now](const Connection& connection) {
    return connection.is_over() || connection.deadline() < now;
  });
  is_full_ = false;
  if (ready_[ready_.size() - 2] != 0) accept();
  make_room();
}

void Server::accept() {
  for (std::size_t taken = 0; taken < most_connections; ++taken) {
    Socket socket = listener_.accept();
    is_full_ =
        !socket.is_open() && (errno == EMFILE || errno == ENFILE || errno == ENOMEM || errno == ENOBUFS);
    if (!socket.is_open()) return;
    connections_.emplace_back(std::move(socket));
  }
}

void Server::make_room() {
  std::size_t connections = connections_.size(), bytes = 0;
  for (const Connection& connection : connections_) bytes += connection.kept_bytes();
  // The newest one stays, however large its response.
  while (connections > 1 && (connections > most_connections || bytes > most_kept_bytes))
    bytes -= connections_[connections_.size() - connections--].kept_bytes();
  connections_.erase(connections_.begin(), connections_.end() - std::ptrdiff_t(connections));
}

}  // namespace twinray::http
