// SPDX-License-Identifier: Apache-2.0
// What a page sees of a render, asked for as pages do.
#include <fmt/format.h>

#include <chrono>
#include <cstring>
#include <thread>

#include "cli/live/web_server.h"
#include "core/error.h"
#include "core/image.h"
#include "integrators/path.h"
#include "io/picture/image_file.h"
#include "io/scene_file.h"
#include "tests/support/catch.h"
#include "tests/support/html.h"
#include "tests/support/http_client.h"
#include "tests/support/json.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {
namespace {

using Json = nlohmann::json;

/// A small render of the box, of which some layers are kept.
class BoxRender {
 public:
  RenderOptions options() const {
    RenderOptions options;
    options.width = 8;
    options.height = 6;
    options.samples = 2;
    options.layers = {Layer::uv, Layer::depth, Layer::object_matte, Layer::ids};
    options.light_paths = true;
    return options;
  }
  const Scene& scene() const { return scene_; }
  RenderResult result() const {
    const auto accelerator = build_accelerator(Backend::bvh, scene_.geometry);
    return render(scene_, *accelerator, PathIntegrator(scene_, {}), options());
  }

 private:
  Scene scene_ = load_scene(TWINRAY_SOURCE_DIR "/scenes/box.dae").scene;
};

/// A server on a free port, and what it says.
class Page {
 public:
  explicit Page(const std::string& partial = "a_partial.exr")
      : server({"127.0.0.1", 0}, "a.exr", partial), port_(port_of(server.page_address())) {}

  void begin(const BoxRender& box) { server.begin(box.options(), box.scene(), {}); }
  HttpAnswer get(const std::string& target) const { return test::get(port_, target); }
  HttpAnswer post(const std::string& target) const { return ask(port_, "POST", target); }
  Json state() const { return Json::parse(get("/state").body); }
  std::uint16_t port() const { return port_; }

  WebServer server;

 private:
  static std::uint16_t port_of(const std::string& address) {
    return std::uint16_t(std::stoi(address.substr(address.rfind(':') + 1)));
  }
  std::uint16_t port_;
};

/// A render that has begun, a page of it, and what it will end with.
struct BegunRender {
  BegunRender() { page.begin(box); }
  const BoxRender box;
  const RenderResult result = box.result();
  Page page;
};

std::vector<float> floats_of(const std::string& bytes) {
  std::vector<float> values(bytes.size() / sizeof(float));
  std::memcpy(values.data(), bytes.data(), bytes.size());
  return values;
}

std::vector<float> colors_of(const Image& image) {
  std::vector<float> values;
  for (const Rgb& pixel : image.pixels) values.insert(values.end(), {pixel.r, pixel.g, pixel.b});
  return values;
}

}  // namespace

TEST_CASE("the page of a picture is whole by itself, and may do nothing else") {
  const Page page;
  const HttpAnswer answer = page.get("/");
  CHECK(answer.status == 200);
  CHECK(answer.field("Content-Type") == "text/html; charset=utf-8");
  CHECK(answer.field("Content-Security-Policy").starts_with("default-src 'none'; "));
  CHECK(answer.body.starts_with("<!DOCTYPE html>"));
  CHECK(answer.body.find("follow();\n</script>") != std::string::npos);
  CHECK(answer.body.find(":root { color-scheme: dark;") != std::string::npos);
  CHECK(answer.body.find("@page_") == std::string::npos);
  CHECK(answer.body.find("//") != std::string::npos);
  CHECK(answer.body.find("http") == std::string::npos);
}

TEST_CASE("a page is told how far the render is") {
  const BoxRender box;
  Page page;
  Json state = page.state();
  CHECK(state["phase"] == "loading");
  CHECK(state["picture"] == "a.exr");
  CHECK(state["width"] == 0);
  CHECK(state["share"] == 0);
  page.begin(box);
  page.server.progress({.samples_done = 24, .samples_total = 96, .rays = 1000});
  state = page.state();
  CHECK(state["phase"] == "rendering");
  CHECK(state["width"] == 8);
  CHECK(state["height"] == 6);
  CHECK(state["samples"] == Json{{"done", 0.5}, {"total", 2}});
  CHECK(state["share"] == 0.25);
  CHECK(state["rays"] == 1000);
  CHECK(state["rays_per_second"] > 0);
  CHECK(state["seconds_left"] > 0);
  CHECK(state["can_stop"] == true);
  CHECK(state["layers"].size() == 4 + light_path_count);
  CHECK(state["layers"][0] == Json{{"name", "beauty"}, {"channels", {"R", "G", "B"}}, {"version", 0}});
  CHECK(state["layers"][1]["name"] == "uv");
  CHECK(state["layers"][2] == Json{{"name", "depth"}, {"channels", {"Z"}}, {"version", 0}});
  CHECK(state["layers"][3]["channels"] == Json{"object_id", "material_id", "instance_id"});
  CHECK(state["layers"][4]["name"] == "emission");
  page.server.show_last(box.result());
  state = page.state();
  CHECK(state["phase"] == "ended");
  CHECK(state["complete"] == true);
  CHECK(state["share"] == 1);
}

TEST_CASE("where time is to end a render a page is told no number of samples") {
  const BoxRender box;
  Page page;
  RenderOptions options = box.options();
  page.server.begin(options, box.scene(), {});
  page.server.progress({.samples_done = 1, .samples_total = 1'000'000'000, .seconds_total = 1e-9});
  const Json state = page.state();
  CHECK(state["samples"]["total"] == nullptr);
  CHECK(state["share"] == 1);
}

TEST_CASE("a page gets the means of the film, all bits of them, and each version once") {
  const BoxRender box;
  const RenderResult result = box.result();
  Page page;
  CHECK(page.get("/picture").status == 204);
  page.begin(box);
  CHECK(page.get("/picture").status == 204);
  page.server.show(result.film);
  const HttpAnswer first = page.get("/picture?layer=beauty");
  CHECK(first.status == 200);
  CHECK(first.field("Picture-Version") == "1");
  CHECK(first.field("Picture-Width") == "8");
  CHECK(first.field("Picture-Height") == "6");
  CHECK(floats_of(first.body) == colors_of(mean_image(result.film)));
  CHECK(page.get("/picture?since=1").status == 204);
  page.server.show(result.film);
  CHECK(page.get("/picture?since=1").status == 204);  // Nothing changed.
  CHECK(page.state()["layers"][0]["version"] == 1);
}

TEST_CASE("a page gets tiles while others are rendered, and of a picture that it knows those that changed") {
  const BoxRender box;
  RenderOptions options = box.options();
  options.width = 40;  // three tiles
  options.samples = 1;
  options.threads = 1;
  Page page;
  page.server.begin(options, box.scene(), {});
  page.get("/picture");
  Film before(40, 6, {0, 0, 40, 6});
  for (int y = 0; y < 6; ++y)
    for (int x = 0; x < 40; ++x) before.add(x, y, 0, {9, 9, 9});
  page.server.show(before);
  page.get("/picture");
  std::this_thread::sleep_for(std::chrono::milliseconds(250));  // Tiles are due again.
  std::vector<std::string> places;
  options.tile_done = [&](const Film& film, const PixelRect& tile) {
    page.server.show_tile(film, tile);
    const HttpAnswer answer = page.get(fmt::format("/picture?since={}", 3 + places.size()));
    CHECK(answer.status == 200);
    CHECK(answer.field("Picture-Tiles") == "1");
    CHECK(answer.field("Picture-Version") == std::to_string(3 + places.size() + 1));
    REQUIRE(answer.body.size() > 16);
    std::uint32_t place[4];
    std::memcpy(place, answer.body.data(), sizeof(place));
    CHECK(PixelRect{int(place[0]), int(place[1]), int(place[0] + place[2]), int(place[1] + place[3])} ==
          tile);
    std::vector<float> values;
    for (int y = tile.y0; y < tile.y1; ++y)
      for (int x = tile.x0; x < tile.x1; ++x) {
        const Rgb color = film.pixel(x, y).mean();
        values.insert(values.end(), {color.r, color.g, color.b});
      }
    CHECK(floats_of(answer.body.substr(16)) == values);
    places.push_back(answer.body.substr(0, 16));
  };
  const auto accelerator = build_accelerator(Backend::bvh, box.scene().geometry);
  const RenderResult result = render(box.scene(), *accelerator, PathIntegrator(box.scene(), {}), options);
  CHECK(places.size() == 3);
  CHECK(floats_of(page.get("/picture").body) == colors_of(mean_image(result.film)));
}

TEST_CASE("tiles that came within a fifth of a second are shown after the pass") {
  BegunRender begun;
  auto& [box, result, page] = begun;
  page.get("/picture");
  const Film empty(8, 6, {0, 0, 8, 6}, result.film.contents());
  const PixelRect all{0, 0, 8, 6};
  page.server.show_tile(empty, all);
  page.server.show_tile(result.film, all);
  CHECK(floats_of(page.get("/picture").body) == std::vector<float>(8 * 6 * 3, 0));
  page.server.show(result.film);
  CHECK(floats_of(page.get("/picture").body) == colors_of(mean_image(result.film)));
}

TEST_CASE("a page that begins to look needs the film once") {
  BegunRender begun;
  auto& [box, result, page] = begun;
  CHECK_FALSE(page.server.needs_film());
  page.get("/picture");
  CHECK(page.server.needs_film());
  page.server.show(result.film);
  CHECK_FALSE(page.server.needs_film());
  page.get("/picture?since=1");
  CHECK_FALSE(page.server.needs_film());
  page.get("/picture?layer=depth");
  CHECK(page.server.needs_film());
}

TEST_CASE("a page that looks again gets what came in the meantime, also after the end") {
  const BoxRender box;
  const RenderResult result = box.result();
  const Film empty(8, 6, {0, 0, 8, 6}, result.film.contents());
  Page again, late;
  for (Page* const page : {&again, &late}) {
    page->begin(box);
    page->get("/picture");
    page->server.show(empty);
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(3100));  // Longer than a page is waited for.
  again.server.show_tile(result.film, {0, 0, 8, 6});             // Nobody looks.
  again.get("/picture");
  CHECK(again.server.needs_film());
  again.server.show(result.film);
  CHECK(floats_of(again.get("/picture").body) == colors_of(mean_image(result.film)));
  late.server.show_last(result);
  CHECK(floats_of(late.get("/picture").body) == colors_of(mean_image(result.film)));
}

TEST_CASE("a page may look at more than the film keeps") {
  const BoxRender box;
  const RenderResult result = box.result();
  Page page;
  page.server.begin(box.options(), box.scene(), {{"place", {"X", "Y"}, [](const Film&, int x, int y) {
                                                    return Rgb{float(x), float(y), 0};
                                                  }}});
  CHECK(page.state()["layers"].back()["channels"] == Json{"X", "Y"});
  page.get("/picture?layer=place");
  page.server.show(result.film);
  const std::vector<float> values = floats_of(page.get("/picture?layer=place").body);
  REQUIRE(values.size() == 8 * 6 * 2);
  CHECK(values[2 * (8 * 4 + 3)] == 3);
  CHECK(values[2 * (8 * 4 + 3) + 1] == 4);
}

TEST_CASE("a page gets a layer's channels from the pass after it asked for them") {
  BegunRender begun;
  auto& [box, result, page] = begun;
  page.get("/picture");
  page.server.show(result.film);
  for (const std::string layer : {"depth", "uv", "diffuse_direct"})
    CHECK(page.get("/picture?layer=" + layer).status == 204);
  page.server.show(result.film);
  std::vector<float> depths, coordinates, direct;
  std::vector<Rgb> parts(light_path_count);
  for (int y = 0; y < 6; ++y)
    for (int x = 0; x < 8; ++x) {
      const Rgb uv = result.film.value(0, x, y);
      coordinates.insert(coordinates.end(), {uv.r, uv.g});
      depths.push_back(result.film.value(1, x, y).r);
      result.film.read_parts(Division::paths, x, y, parts);
      const Rgb& part = parts[std::size_t(LightPath::diffuse_direct)];
      direct.insert(direct.end(), {part.r, part.g, part.b});
    }
  CHECK(floats_of(page.get("/picture?layer=depth").body) == depths);
  CHECK(floats_of(page.get("/picture?layer=uv").body) == coordinates);
  CHECK(floats_of(page.get("/picture?layer=diffuse_direct").body) == direct);
  CHECK(floats_of(page.get("/picture?layer=diffuse_direct").body) != colors_of(mean_image(result.film)));
}

TEST_CASE("a picture is saved as a PFM with all bits, also of a layer of one channel or two") {
  BegunRender begun;
  auto& [box, result, page] = begun;
  const TemporaryFolder folder;
  CHECK(page.get("/picture.pfm").status == 404);
  for (const std::string layer : {"beauty", "depth", "uv"}) page.get("/picture?layer=" + layer);
  page.server.show(result.film);
  write_text(folder.file("a.pfm"), page.get("/picture.pfm").body);
  CHECK(read_image(folder.file("a.pfm")).pixels == mean_image(result.film).pixels);
  write_text(folder.file("b.pfm"), page.get("/picture.pfm?layer=uv").body);
  CHECK(read_image(folder.file("b.pfm")).at(2, 5).g == result.film.value(0, 2, 5).g);
  CHECK(page.get("/picture.pfm?layer=depth").body.starts_with("Pf\n8 6\n-1\n"));
}

TEST_CASE("copies are made for whoever asked since the last one, and for nobody else") {
  BegunRender begun;
  auto& [box, result, page] = begun;
  CHECK_FALSE(page.server.is_ready());
  page.get("/");
  page.state();
  CHECK_FALSE(page.server.is_ready());
  page.get("/picture");
  CHECK(page.server.is_ready());
  page.server.show(result.film);
  CHECK_FALSE(page.server.is_ready());
  page.get("/picture?since=1");
  CHECK(page.server.is_ready());
}

TEST_CASE("what a page cannot have is refused with what would be valid") {
  const BoxRender box;
  Page page;
  page.begin(box);
  const HttpAnswer layer = page.get("/picture?layer=z");
  CHECK(layer.status == 400);
  CHECK(layer.body.starts_with("There is no layer \"z\"; valid are beauty, uv, depth, ids, emission, "));
  for (const std::string since : {"", "-1", "1.5", "x", "99999999999999999999"}) {
    const HttpAnswer answer = page.get("/picture?since=" + since);
    CHECK(answer.status == 400);
    CHECK(answer.body == "since: \"" + since + "\" is no version; valid are whole numbers from 0 on.\n");
  }
  const HttpAnswer place = page.get("/stat");
  CHECK(place.status == 404);
  CHECK(place.body == "There is no such page; valid are /, /state, /picture, /picture.pfm and /stop.\n");
  const HttpAnswer method = page.post("/state");
  CHECK(method.status == 405);
  CHECK(method.field("Allow") == "GET");
  CHECK(method.body == "/state takes GET alone.\n");
  CHECK(page.get("/stop").field("Allow") == "POST");
  HttpClient stranger(page.port());
  stranger.send("PUT /stop HTTP/1.1\r\nHost: localhost\r\n\r\n");
  const HttpAnswer put = stranger.answer();
  CHECK(put.status == 405);
  CHECK(put.field("Allow") == "POST");
  CHECK_FALSE(page.server.asks_to_stop());
}

TEST_CASE("a page stops a render that has begun, of which something is kept, once") {
  const BoxRender box;
  Page page;
  CHECK(page.post("/stop").body == "The render has not begun.\n");
  page.begin(box);
  CHECK_FALSE(page.server.asks_to_stop());
  HttpClient stranger(page.port());
  stranger.send("POST /stop HTTP/1.1\r\nHost: localhost\r\nOrigin: http://evil.example\r\n\r\n");
  CHECK(stranger.answer().status == 403);
  CHECK_FALSE(page.server.asks_to_stop());
  CHECK(page.post("/stop").status == 204);
  CHECK(page.server.asks_to_stop());
  CHECK(page.state()["stopping"] == true);
  page.server.show_last(box.result());
  CHECK(page.post("/stop").status == 409);
  Page of_device("");
  of_device.begin(box);
  CHECK(of_device.state()["can_stop"] == false);
  CHECK(of_device.post("/stop").body == "The picture goes to no file that could keep a part of it.\n");
  CHECK_FALSE(of_device.server.asks_to_stop());
}

TEST_CASE("a page of another name for this machine is refused") {
  const Page page;
  HttpClient client(page.port());
  client.send("GET /state HTTP/1.1\r\nHost: evil.example\r\n\r\n");
  CHECK(client.answer().status == 403);
}

TEST_CASE("a server's address is a port, a host, both or none") {
  CHECK(text_of(parse_server_address("")) == "127.0.0.1:8184");
  CHECK(text_of(parse_server_address("0")) == "127.0.0.1:0");
  CHECK(text_of(parse_server_address("9000")) == "127.0.0.1:9000");
  CHECK(text_of(parse_server_address("desk")) == "desk:8184");
  CHECK(text_of(parse_server_address("[::]:1")) == "[::]:1");
  CHECK_THROWS_WITH(parse_server_address("65536"),
                    "\"65536\" is no port in \"127.0.0.1:65536\"; valid are 0 to 65535");
}

}  // namespace twinray::test
