// SPDX-License-Identifier: Apache-2.0
// A viewer for tests: listens where tev would, and reads its packets.
#pragma once
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace twinray::test {

/// A packet as a viewer understands it.
struct ViewerPacket {
  int operation = -1;
  std::string name;
  int width = 0, height = 0;  ///< Of the picture, or of the part that is given.
  int x = 0, y = 0;           ///< Where that part begins.
  std::vector<std::string> channels;
  std::vector<std::int64_t> offsets, strides;
  std::vector<float> values;
  std::size_t bytes = 0;  ///< Its whole length.
};

/// Throws std::runtime_error for a packet that is not well-formed: too short, too long.
ViewerPacket read_packet(const std::string& bytes);

/// Listens on a free port of this machine until it goes.
class ViewerServer {
 public:
  /// What it does with a connection: reads all that comes; nothing, but keeps it open; reads one packet and
  /// closes.
  enum class Manner { reads_all, reads_nothing, closes_after_a_packet };
  explicit ViewerServer(Manner manner);
  ~ViewerServer();
  ViewerServer(const ViewerServer&) = delete;
  ViewerServer& operator=(const ViewerServer&) = delete;

  std::uint16_t port() const { return port_; }
  /// How often somebody connected, once that is so many times at least.
  int wait_for_connections(int count);
  /// All packets, once the last connection was closed by the other side.
  std::vector<ViewerPacket> wait_for_end();

 private:
  void run();
  void read(int connection);

  const Manner manner_;
  int listener_ = -1, wake_[2] = {-1, -1};
  std::uint16_t port_ = 0;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<ViewerPacket> packets_;
  int connections_ = 0, ended_ = 0;
  std::vector<int> kept_;  ///< Open, and not read.
  std::thread thread_;
};

/// A port of this machine where nobody listens.
std::uint16_t free_port();

}  // namespace twinray::test
