// SPDX-License-Identifier: Apache-2.0
// Pictures in a viewer, whatever the viewer does.
#include "io/network/tev_viewer.h"

#include <optional>
#include <thread>

#include "core/error.h"
#include "tests/support/catch.h"
#include "tests/support/viewer_server.h"

namespace twinray::test {
namespace {

using Manner = ViewerServer::Manner;

/// All values are this one.
ViewerPicture picture_of(int width, int height, float value) {
  ViewerPicture picture{"a.exr", width, height, {"R", "G", "B"}, {}};
  picture.values.assign(std::size_t(3 * width * height), value);
  return picture;
}

std::string text_of_bytes(std::initializer_list<int> bytes) {
  std::string text;
  for (const int byte : bytes) text += char(byte);
  return text;
}

std::string fault_of(const std::string& text) {
  try {
    parse_viewer_address(text);
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

void wait_until_idle(const TevViewer& viewer) {
  while (!viewer.is_idle()) std::this_thread::yield();
}

}  // namespace

TEST_CASE("a packet that opens a picture has the bytes of tev's protocol") {
  const ViewerPicture picture{"a", 258, 3, {"R", "Z"}, {}};
  CHECK(create_packet(picture) ==
        text_of_bytes({24, 0, 0, 0, 4, 0, 'a', 0, 2, 1, 0, 0, 3, 0, 0, 0, 2, 0, 0, 0, 'R', 0, 'Z', 0}));
}

TEST_CASE("a packet of pixels has the bytes of tev's protocol") {
  const ViewerPicture picture{"a", 1, 2, {"R", "Z"}, {0, 0, 1, -2}};
  const std::string bytes = update_packet(picture, 1, 2);
  CHECK(bytes.substr(0, 32) == text_of_bytes({72, 0, 0, 0, 6, 0, 'a', 0, 2, 0, 0, 0, 'R', 0, 'Z', 0,
                                              0,  0, 0, 0, 1, 0, 0,   0, 1, 0, 0, 0, 1,   0, 0,   0}));
  CHECK(bytes.substr(32, 32) == text_of_bytes({0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0,
                                               2, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0}));
  CHECK(bytes.substr(64) == text_of_bytes({0, 0, 0x80, 0x3f, 0, 0, 0, 0xc0}));
}

TEST_CASE("a packet has about a megabyte, or a row where that has more") {
  CHECK(rows_a_packet(picture_of(1000, 1, 0)) == 83);
  CHECK(rows_a_packet({"a", 1'000'000, 1, {"R"}, {}}) == 1);
}

TEST_CASE("a viewer's address is a host, a port, both or none") {
  CHECK(text_of(parse_viewer_address("")) == "127.0.0.1:14158");
  CHECK(text_of(parse_viewer_address("desk")) == "desk:14158");
  CHECK(text_of(parse_viewer_address("desk:1")) == "desk:1");
  CHECK(text_of(parse_viewer_address(":65535")) == "127.0.0.1:65535");
  CHECK(text_of(parse_viewer_address("[::1]:80")) == "[::1]:80");
  CHECK(parse_viewer_address("[::1]").host == "::1");
  CHECK(fault_of("desk:0") == "\"0\" is no port in \"desk:0\"; valid are 1 to 65535");
  CHECK(fault_of("desk:65536") == "\"65536\" is no port in \"desk:65536\"; valid are 1 to 65535");
  CHECK(fault_of("desk:") == "\"\" is no port in \"desk:\"; valid are 1 to 65535");
  CHECK(fault_of("[::1") == "\"[::1\": the bracket is not closed");
  CHECK(fault_of("[::1]80") == "\"[::1]80\" is not HOST:PORT");
}

TEST_CASE("a viewer gets a picture once, and then its pixels, the last ones for certain") {
  ViewerServer server(Manner::reads_all);
  {
    TevViewer viewer({"127.0.0.1", server.port()});
    for (const float value : {1.0f, 2.0f}) {
      wait_until_idle(viewer);
      viewer.show(picture_of(300, 400, value));
    }
    viewer.show(picture_of(300, 400, 3));
    viewer.finish();
    CHECK(viewer.fault() == "");
  }
  const std::vector<ViewerPacket> packets = server.wait_for_end();
  REQUIRE(packets.size() >= 5);
  CHECK(packets[0].operation == 4);
  CHECK(packets[0].name == "a.exr");
  CHECK(packets[0].width == 300);
  CHECK(packets[0].height == 400);
  CHECK(packets[0].channels == std::vector<std::string>{"R", "G", "B"});
  int next_row = 0;
  for (std::size_t i = 1; i < packets.size(); ++i) {
    const ViewerPacket& packet = packets[i];
    CHECK(packet.operation == 6);
    CHECK(packet.y == next_row);
    CHECK(packet.width == 300);
    CHECK(packet.offsets == std::vector<std::int64_t>{0, 1, 2});
    CHECK(packet.strides == std::vector<std::int64_t>{3, 3, 3});
    REQUIRE(packet.values.size() == std::size_t(900 * packet.height));
    CHECK(packet.bytes < 1'048'576);
    next_row = (packet.y + packet.height) % 400;
  }
  CHECK(next_row == 0);
  CHECK(packets[1].values.front() == 1);
  CHECK(packets.back().values.back() == 3);
}

TEST_CASE("a viewer that never reads holds nobody up, and is named as too slow") {
  ViewerServer server(Manner::reads_nothing);
  TevViewer viewer({"127.0.0.1", server.port()});
  wait_until_idle(viewer);
  for (int i = 0; i < 50; ++i) viewer.show(picture_of(1000, 1000, float(i)));
  CHECK_FALSE(viewer.is_idle());
  viewer.finish();
  CHECK(viewer.fault() == "it takes pictures too slowly");
}

TEST_CASE("a viewer that goes is looked for again, and gets the picture anew") {
  ViewerServer server(Manner::closes_after_a_packet);
  TevViewer viewer({"127.0.0.1", server.port()});
  for (int connection = 1; connection <= 2; ++connection) {
    wait_until_idle(viewer);
    while (server.wait_for_connections(1) < connection) viewer.show(picture_of(1000, 1000, 1));
    viewer.show(picture_of(1000, 1000, 1));
    while (viewer.fault().empty()) viewer.show(picture_of(1000, 1000, 1));
  }
  viewer.finish();
  const std::vector<ViewerPacket> packets = server.wait_for_end();
  REQUIRE(packets.size() >= 2);
  for (const ViewerPacket& packet : packets) CHECK(packet.operation == 4);
}

TEST_CASE("a viewer that goes without a word is noticed before the next picture") {
  std::optional<ViewerServer> server(std::in_place, Manner::reads_nothing);
  const TevViewer viewer({"127.0.0.1", server->port()});
  wait_until_idle(viewer);
  server->wait_for_connections(1);  // else it would be refused, not closed
  server.reset();
  while (viewer.fault().empty()) std::this_thread::yield();
  CHECK_FALSE(viewer.is_idle());
}

TEST_CASE("a viewer that is not there holds nobody up, and is named with the reason") {
  TevViewer viewer({"127.0.0.1", free_port()});
  viewer.show(picture_of(10, 10, 1));
  CHECK_FALSE(viewer.is_idle());
  viewer.finish();
  CHECK(viewer.fault() == "Connection refused");
}

}  // namespace twinray::test
