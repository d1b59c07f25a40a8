// SPDX-License-Identifier: Apache-2.0
// --layers: names, errors, and the file that comes out.
#include <fmt/format.h>

#include "cli/layered_picture.h"
#include "cli/render_command_line.h"
#include "core/error.h"
#include "io/image_file.h"
#include "tests/support/catch.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {
namespace {

const std::string scene = TWINRAY_SOURCE_DIR "/scenes/box.dae";

std::vector<Layer> layers_of(const std::vector<std::string>& options) {
  std::vector<std::string> words = options;
  words.push_back("scene.dae");
  return parse_render_arguments(words).render.layers;
}

std::string message_of(std::vector<std::string> words) {
  words.push_back("scene.dae");
  try {
    parse_render_arguments(words);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "accepted";
}

/// Whether an EXR has a channel of this name and type: 1 for 16 bits, 2 for 32.
bool has_channel(const std::string& file, const std::string& name, char type) {
  return file.find('\0' + name + '\0' + type + std::string(3, '\0')) != file.npos;
}

}  // namespace

TEST_CASE("layers are named with commas, each once and in the order of the file") {
  CHECK(layers_of({}).empty());
  CHECK(layers_of({"--layers=normal,depth,albedo,normal"}) ==
        std::vector{Layer::alpha, Layer::albedo, Layer::normal, Layer::depth});
  CHECK(layers_of({"--layers", "alpha"}) == std::vector{Layer::alpha});
  CHECK(layers_of({"--layers=all"}) == all_layers());
  CHECK(layers_of({"--layers=depth,all"}) == all_layers());
  CHECK(layers_of({"--layers=light"}).size() == 1 + light_parts().size());
}

TEST_CASE("layers that there are not, and pictures that cannot hold any, are refused with what is valid") {
  CHECK(message_of({"--layers=albedo,colour"}) ==
        "--layers: there is no \"colour\"; valid are all, alpha, albedo, normal, geometric-normal, depth, "
        "position, uv, ids, samples, variance, light, one or several with commas");
  CHECK(message_of({"--layers=emission"}).starts_with("--layers: there is no \"emission\""));
  CHECK(message_of({"--layers=albedo,,depth"}).starts_with("--layers: there is no \"\""));
  CHECK(message_of({"--layers=all", "-o", "a.png"}) ==
        "--layers: a.png cannot hold layers; the name of a picture that can ends in .exr");
  CHECK(message_of({"--layers=all", "-o", "-"}).starts_with("--layers: - cannot hold layers"));
  CHECK(message_of({"--layers=all", "--integrator=normals"}) ==
        "--layers: --integrator=normals knows of none; path, path-reference and direct do");
  CHECK(message_of({"--layers=all", "-o", "a.exr"}) == "accepted");
  CHECK(parse_render_arguments({"--layers=all", "a.dae"}).output == "twinray.exr");
}

TEST_CASE("a picture with all layers has their channels, and the colours that it has alone") {
  const TemporaryFolder folder;
  const std::string render = fmt::format("{} -r 24 18 -s 4 -q -o ", scene);
  REQUIRE(run_program(render + folder.file("alone.exr")).exit_code == 0);
  REQUIRE(run_program(render + folder.file("all.exr") + " --layers=all").exit_code == 0);
  CHECK(read_image(folder.file("all.exr")).pixels == read_image(folder.file("alone.exr")).pixels);
  const std::string file = read_text(folder.file("all.exr"));
  for (const Layer layer : all_layers())
    for (const char* const channel : layer_info(layer).channels) {
      CAPTURE(channel);
      CHECK(has_channel(file, channel, layer_info(layer).is_half ? 1 : 2));
    }
  for (const std::string name : {"worldToCamera", "worldToNDC"}) {
    CHECK(file.find(name) != file.npos);
    CHECK(read_text(folder.file("alone.exr")).find(name) != std::string::npos);
  }
  CHECK_FALSE(has_channel(read_text(folder.file("alone.exr")), "A", 2));
}

TEST_CASE("pictures with layers have the same bytes, whichever engine and path tracer made them") {
  const TemporaryFolder folder;
  const auto pixels = [&](const std::string& options) {
    REQUIRE(run_program(fmt::format("{} -r 24 18 -s 4 -q --layers=all -o {} {}", scene, folder.file("a.exr"),
                                    options))
                .exit_code == 0);
    const std::string file = read_text(folder.file("a.exr")), last = "worldToNDC";
    // The metadata name the options; behind the last of them are the places of two blocks of 16 rows.
    const std::size_t end_of_header = file.find(last) + last.size() + sizeof "" + sizeof "m44f" + 4 + 64 + 1;
    return file.substr(end_of_header + 2 * sizeof(std::uint64_t));
  };
  const std::string expected = pixels("");
  for (const std::string options :
       {"--accel=bvh --bvh-width=2", "--accel=brute-force", "-t 1", "-t 3", "--integrator=path-reference"}) {
    CAPTURE(options);
    CHECK(pixels(options) == expected);
  }
}

TEST_CASE("a part of the frame with layers is that part of the whole") {
  Film whole(6, 4, {0, 0, 6, 4}, {Layer::alpha, Layer::depth}), part(6, 4, {2, 1, 5, 3}, whole.layers());
  for (Film* const film : {&whole, &part})
    for (int y = film->window().y0; y < film->window().y1; ++y)
      for (int x = film->window().x0; x < film->window().x1; ++x)
        film->add(x, y, 0, {float(x), float(y), 0}, std::vector<Rgb>{{1, 0, 0}, {float(10 * y + x), 0, 0}});
  const auto row = [](const Film& film, int y) {
    const LayeredImage image = layered_picture(film);
    std::vector<float> values(std::size_t(image.width) * image.channels.size());
    image.fill_row(y, values);
    return values;
  };
  CHECK(row(part, 1) == std::vector<float>{2, 2, 0, 1, 22, 3, 2, 0, 1, 23, 4, 2, 0, 1, 24});
  CHECK(row(whole, 3).back() == 35);
}

}  // namespace twinray::test
