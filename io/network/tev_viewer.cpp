// SPDX-License-Identifier: Apache-2.0
#include "io/network/tev_viewer.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>

#include "core/error.h"
#include "io/network/tcp_connection.h"

namespace twinray {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds retry_interval{1}, last_wait{1};
/// How often a viewer that gets no pictures is asked whether it is still there.
constexpr std::chrono::milliseconds watch_interval{100};

}  // namespace

NetworkAddress parse_viewer_address(const std::string& text) {
  return parse_address(text, {"127.0.0.1", 14158}, 1);
}

/// What the thread and its owner share. All but `address` under the lock.
struct TevViewer::State {
  explicit State(const NetworkAddress& where) : address(where) {}

  const NetworkAddress address;
  mutable std::mutex mutex;
  std::condition_variable changed;
  std::optional<ViewerPicture> next;  ///< Waits to be sent.
  bool is_connected = false, is_sending = false;
  std::string fault;
  std::optional<Clock::time_point> end;  ///< No picture follows; from then on nothing is sent.
  bool has_ended = false;                ///< The thread.

  bool gives_up() const {
    const std::lock_guard lock(mutex);
    return end && (Clock::now() >= *end || (!is_sending && !next));
  }
  void set_connected(bool connected, const std::string& why_not) {
    const std::lock_guard lock(mutex);
    is_connected = connected;
    is_sending = false;
    fault = why_not;
  }

  void run();
  void serve(TcpConnection connection);
  std::optional<ViewerPicture> take();
  bool send(TcpConnection& connection, const ViewerPicture& picture);
};

/// The next picture; none where there is none for a while.
std::optional<ViewerPicture> TevViewer::State::take() {
  std::unique_lock lock(mutex);
  is_sending = false;
  changed.wait_for(lock, watch_interval, [this] { return next || end; });
  is_sending = next.has_value();
  return std::exchange(next, std::nullopt);
}

bool TevViewer::State::send(TcpConnection& connection, const ViewerPicture& picture) {
  const auto stop = [this] { return gives_up(); };
  const int rows = rows_a_packet(picture);
  for (int y = 0; y < picture.height; y += rows)
    if (!connection.send(update_packet(picture, y, std::min(y + rows, picture.height)), stop)) return false;
  return true;
}

void TevViewer::State::serve(TcpConnection connection) {
  set_connected(true, "");
  bool is_created = false;
  while (!gives_up()) {
    const std::optional<ViewerPicture> picture = take();
    if (!picture && connection.is_closed_by_peer()) throw Error("it has closed the connection");
    if (!picture) continue;
    if (!is_created && !connection.send(create_packet(*picture), [this] { return gives_up(); })) break;
    is_created = true;
    if (!send(connection, *picture)) break;
  }
  if (const std::lock_guard lock(mutex); is_sending || next) fault = "it takes pictures too slowly";
}

void TevViewer::State::run() {
  while (!gives_up()) {
    try {
      serve(TcpConnection(address.host, address.port, [this] { return gives_up(); }));
    } catch (const std::exception& error) {
      set_connected(false, error.what());
    }
    std::unique_lock lock(mutex);
    changed.wait_for(lock, retry_interval, [this] { return end.has_value(); });
    if (end && !is_connected) break;  // Nobody is there for what is left.
  }
  const std::lock_guard lock(mutex);
  has_ended = true;
  changed.notify_all();
}

TevViewer::TevViewer(const NetworkAddress& address) : state_(std::make_shared<State>(address)) {
  try {
    std::thread([state = state_] { state->run(); }).detach();
  } catch (const std::system_error& error) {
    state_->fault = error.what();
    state_->has_ended = true;
  }
}

TevViewer::~TevViewer() { finish(); }

void TevViewer::finish() {
  std::unique_lock lock(state_->mutex);
  if (!state_->end) state_->end = Clock::now() + last_wait;
  state_->changed.notify_all();
  state_->changed.wait_until(lock, *state_->end + last_wait, [this] { return state_->has_ended; });
}

bool TevViewer::is_idle() const {
  const std::lock_guard lock(state_->mutex);
  return state_->is_connected && !state_->is_sending && !state_->next;
}

void TevViewer::show(ViewerPicture picture) {
  const std::lock_guard lock(state_->mutex);
  state_->next = std::move(picture);
  state_->changed.notify_all();
}

std::string TevViewer::fault() const {
  const std::lock_guard lock(state_->mutex);
  return state_->fault;
}

}  // namespace twinray
