// SPDX-License-Identifier: Apache-2.0
// A render that a viewer watches, as a user starts it.
#include <fmt/format.h>

#include "io/picture/image_file.h"
#include "tests/support/catch.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/viewer_server.h"

namespace twinray::test {
namespace {

const std::string quoted_spheres = quoted(TWINRAY_SOURCE_DIR "/scenes/spheres.dae");

ProcessResult render(const std::string& output, const std::string& options) {
  return run_program(quoted_spheres + " -r 40 30 -s 16 -m 2 -q -o " + quoted(output) + " " + options);
}

}  // namespace

TEST_CASE("a viewer ends with the picture that is saved, and the file has the bytes that it has without") {
  const TemporaryFolder folder;
  ViewerServer server(ViewerServer::Manner::reads_all);
  const ProcessResult result = render(folder.file("a.exr"), fmt::format("--tev=127.0.0.1:{}", server.port()));
  CHECK(result.exit_code == 0);
  CHECK(result.err.empty());
  const std::vector<ViewerPacket> packets = server.wait_for_end();
  REQUIRE(packets.size() >= 2);
  CHECK(packets[0].name == folder.file("a.exr"));
  CHECK(packets[0].width == 40);
  CHECK(packets[0].height == 30);
  const Image saved = read_image(folder.file("a.exr"));
  std::vector<float> values;
  for (const Rgb& pixel : saved.pixels) values.insert(values.end(), {pixel.r, pixel.g, pixel.b});
  CHECK(packets.back().values == values);
  REQUIRE(render(folder.file("b.exr"), "").exit_code == 0);
  CHECK(read_image(folder.file("b.exr")).pixels == saved.pixels);
}

TEST_CASE("a viewer gets the layers that the file has, by the same names") {
  const TemporaryFolder folder;
  ViewerServer server(ViewerServer::Manner::reads_all);
  const std::string picture = folder.file("a.exr");
  REQUIRE(
      render(picture, fmt::format("--layers=depth,light,light-groups --tev=:{}", server.port())).exit_code ==
      0);
  const std::vector<ViewerPacket> packets = server.wait_for_end();
  REQUIRE_FALSE(packets.empty());
  const ViewerPacket& last = packets.back();
  CHECK(last.channels.size() == StoredLayers(read_layers(picture)).channels.size());
  for (std::size_t channel = 0; channel < last.channels.size(); ++channel) {
    CAPTURE(last.channels[channel]);
    std::vector<float> values;
    for (std::size_t i = channel; i < last.values.size(); i += last.channels.size())
      values.push_back(last.values[i]);
    CHECK(values == read_channel(picture, last.channels[channel]));
  }
}

TEST_CASE("a viewer that is not there is a warning, and the picture is saved") {
  const TemporaryFolder folder;
  const int port = free_port();
  const ProcessResult result = render(folder.file("a.png"), fmt::format("--tev=:{}", port));
  CHECK(result.exit_code == 0);
  CHECK(result.err ==
        fmt::format(
            "warning: --tev: the viewer at 127.0.0.1:{} does not have the picture: Connection refused\n",
            port));
  CHECK_FALSE(read_image(folder.file("a.png")).pixels.empty());
}

TEST_CASE("a viewer's address that is none is refused before the render") {
  const TemporaryFolder folder;
  const ProcessResult result = render(folder.file("a.png"), "--tev=desk:x");
  CHECK(result.exit_code == 2);
  CHECK(result.err.starts_with("twinray: --tev: \"x\" is no port in \"desk:x\"; valid are 1 to 65535\n"));
  CHECK_FALSE(std::filesystem::exists(folder.file("a.png")));
}

}  // namespace twinray::test
