// SPDX-License-Identifier: Apache-2.0
// The program while pages look at its picture.
#include <fmt/format.h>
#include <signal.h>

#include <algorithm>
#include <cstring>
#include <list>

#include "io/network/tcp_listener.h"
#include "io/picture/image_file.h"
#include "tests/support/catch.h"
#include "tests/support/http_client.h"
#include "tests/support/json.h"
#include "tests/support/own_scenes.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/terminal.h"

namespace twinray::test {
namespace {

using Json = nlohmann::json;

std::vector<std::string> command(const std::string& path, const std::string& samples,
                                 std::vector<std::string> more = {"--serve=0"}) {
  std::vector<std::string> words{box_scene, "-r", "40", "30", "-s", samples, "-o", path, "-q"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// The port in the address that the program says.
std::uint16_t port_of(TerminalProgram& program) {
  REQUIRE(program.wait_for("/\r\n"));
  const std::string& shown = program.shown();
  const std::string address = "http://127.0.0.1:";
  REQUIRE(shown.find(address) != std::string::npos);
  return std::uint16_t(std::stoi(shown.substr(shown.find(address) + address.size())));
}

/// What a page has once the render has ended: the state, and the newest picture.
struct LastPicture {
  Json state;
  HttpAnswer picture;
};

LastPicture follow(std::uint16_t port, const std::string& layer = "beauty") {
  LastPicture last;
  do {
    last.state = Json::parse(get(port, "/state").body);
    if (HttpAnswer answer = get(port, "/picture?layer=" + layer); answer.status == 200)
      last.picture = std::move(answer);
  } while (last.state["phase"] != "ended");
  return last;
}

std::string bytes_of(const Image& image) {
  std::string bytes(image.pixels.size() * sizeof(Rgb), '\0');
  std::memcpy(bytes.data(), image.pixels.data(), bytes.size());
  return bytes;
}

}  // namespace

TEST_CASE("a page ends with the picture that is saved, and the file has the bits that it has without") {
  const TemporaryFolder folder;
  TerminalProgram program(command(folder.file("a.exr"), "400"));
  const auto [state, picture] = follow(port_of(program));
  CHECK(program.exit_code() == 0);
  CHECK(state["complete"] == true);
  CHECK(state["picture"] == folder.file("a.exr"));
  const Image saved = read_image(folder.file("a.exr"));
  CHECK(picture.body == bytes_of(saved));
  REQUIRE(run_program(fmt::format("'{}' -r 40 30 -s 400 -q -o '{}'", box_scene, folder.file("b.exr")))
              .exit_code == 0);
  CHECK(read_image(folder.file("b.exr")).pixels == saved.pixels);
}

TEST_CASE("a page may look at the pixels where engines differ while the render runs") {
  const TemporaryFolder folder;
  TerminalProgram program(
      command(folder.file("a.png"), "64", {"--accel=check", "--plant-difference", "--serve=0"}));
  const auto [state, picture] = follow(port_of(program), "differences");
  CHECK(program.exit_code() == 1);
  CHECK(state["layers"].back()["name"] == "differences");
  std::vector<Rgb> pixels(40 * 30);
  REQUIRE(picture.body.size() == pixels.size() * sizeof(Rgb));
  std::memcpy(pixels.data(), picture.body.data(), picture.body.size());
  const Image saved = read_image(folder.file("a_differences.png"));
  std::vector<bool> shown, kept;
  for (const Rgb& pixel : pixels) shown.push_back(pixel == Rgb{1, 0, 0});
  for (const Rgb& pixel : saved.pixels) kept.push_back(pixel == Rgb{1, 0, 0});
  CHECK(shown == kept);
  CHECK(std::count(shown.begin(), shown.end(), true) > 0);
}

TEST_CASE("the button of a page ends the render, which is kept as after Ctrl-C") {
  const TemporaryFolder folder;
  TerminalProgram program(command(folder.file("a.exr"), "4000000"));
  const std::uint16_t port = port_of(program);
  while (get(port, "/picture").status != 200) {
  }
  CHECK(ask(port, "POST", "/stop").status == 204);
  const auto [state, picture] = follow(port);
  CHECK(program.exit_code() == 130);
  CHECK(state["complete"] == false);
  CHECK(state["partial"] == folder.file("a_partial.exr"));
  CHECK(picture.body == bytes_of(read_image(folder.file("a_partial.exr"))));
  CHECK(program.shown().find("twinray: interrupted; " + folder.file("a_partial.exr")) != std::string::npos);
  CHECK(folder.file_count() == 1);
}

TEST_CASE("whoever connects and says nothing, or reads nothing, does not keep the program") {
  const TemporaryFolder folder;
  TerminalProgram program(command(folder.file("a.exr"), "4000000"));
  const std::uint16_t port = port_of(program);
  while (get(port, "/picture").status != 200) {
  }
  std::list<HttpClient> rude;
  for (int i = 0; i < 25; ++i) {
    rude.emplace_back(port);
    rude.emplace_back(port, 4096).send("GET /picture HTTP/1.1\r\nHost: localhost\r\n\r\n");
  }
  CHECK(ask(port, "POST", "/stop").status == 204);
  CHECK(program.exit_code() == 130);
  CHECK(rude.front().answer().status == 0);
}

TEST_CASE("for other machines the program says a token, without which nothing is to be had") {
  const TemporaryFolder folder;
  TerminalProgram program(command(folder.file("a.png"), "4000000", {"--serve=0.0.0.0:0"}));
  REQUIRE(program.wait_for("\r\n"));
  const std::string& shown = program.shown();
  const std::size_t query = shown.find("/?token=");
  REQUIRE(query != std::string::npos);
  const std::string token = shown.substr(query + 8, 32);
  const auto port = std::uint16_t(std::stoi(shown.substr(shown.rfind(':', query) + 1)));
  CHECK(get(port, "/").status == 403);
  CHECK(get(port, "/?token=" + std::string(32, '0')).status == 403);
  CHECK(get(port, "/?token=" + token).status == 200);
  CHECK(ask(port, "POST", "/stop").status == 403);
  program.send(SIGTERM);
  CHECK(program.exit_code() == 143);
}

TEST_CASE("a port that is taken is an error before the render") {
  const TemporaryFolder folder;
  const TcpListener taken({"127.0.0.1", 0});
  const ProcessResult result = run_program(
      fmt::format("'{}' -q -o '{}' --serve={}", box_scene, folder.file("a.png"), taken.address().port));
  CHECK(result.exit_code == 1);
  CHECK(result.err == fmt::format("twinray: --serve: cannot listen at 127.0.0.1:{}: Address already in use; "
                                  "--serve=0 takes any free port of this machine\n",
                                  taken.address().port));
  CHECK_FALSE(std::filesystem::exists(folder.file("a.png")));
}

TEST_CASE("an address to serve at that is none is refused, and of no effect where there is no picture") {
  const ProcessResult wrong = run_program(fmt::format("'{}' --serve=desk:x", box_scene));
  CHECK(wrong.exit_code == 2);
  CHECK(wrong.err.starts_with("twinray: --serve: \"x\" is no port in \"desk:x\"; valid are 0 to 65535\n"));
  const ProcessResult replay = run_program(fmt::format("'{}' --serve=0 --replay 1 1 0", box_scene));
  CHECK(replay.exit_code == 0);
  CHECK(replay.err == "warning: --serve: no effect, for --replay renders no picture\n");
}

}  // namespace twinray::test
