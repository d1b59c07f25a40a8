// SPDX-License-Identifier: Apache-2.0
// --layers: names, errors, and the file that comes out.
#include <fmt/format.h>

#include <bit>
#include <map>

#include "cli/layered_picture.h"
#include "cli/render_command_line.h"
#include "core/error.h"
#include "io/picture/cryptomatte.h"
#include "io/picture/image_file.h"
#include "tests/support/arguments.h"
#include "tests/support/catch.h"
#include "tests/support/film.h"
#include "tests/support/own_scenes.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/text.h"

namespace twinray::test {
namespace {

std::vector<Layer> layers_of(const std::vector<std::string>& options) {
  std::vector<std::string> words = options;
  words.push_back("scene.dae");
  return parse_render_arguments(words).render.layers;
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
  CHECK(layers_of({"--layers=cryptomatte"}) ==
        std::vector{Layer::alpha, Layer::object_matte, Layer::material_matte, Layer::asset_matte});
  const auto light_of = [](const std::string& names) {
    const RenderOptions options = parse_render_arguments({names, "scene.dae"}).render;
    return std::pair(options.light_paths, options.light_groups);
  };
  CHECK(light_of("--layers=light,uv") == std::pair(true, false));
  CHECK(light_of("--layers=light-groups") == std::pair(false, true));
  CHECK(light_of("--layers=all") == std::pair(true, true));
  CHECK(layers_of({"--layers=light"}) == std::vector{Layer::alpha});
}

TEST_CASE("layers that there are not, and pictures that cannot hold any, are refused with what is valid") {
  CHECK(message_of({"--layers=albedo,colour"}) ==
        "--layers: there is no \"colour\"; valid are all, alpha, albedo, normal, geometric-normal, depth, "
        "position, uv, ids, samples, variance, cryptomatte-object, cryptomatte-material, cryptomatte-asset, "
        "cryptomatte, light, light-groups, one or several with commas");
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
  const std::string render = fmt::format("{} -r 24 18 -s 4 -q -o ", box_scene);
  REQUIRE(run_program(render + folder.file("alone.exr")).exit_code == 0);
  REQUIRE(run_program(render + folder.file("all.exr") + " --layers=all").exit_code == 0);
  CHECK(read_image(folder.file("all.exr")).pixels == read_image(folder.file("alone.exr")).pixels);
  const std::string file = read_text(folder.file("all.exr"));
  for (const Layer layer : all_layers())
    for (const std::string& channel : layer_info(layer).channels) {
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
    REQUIRE(run_program(fmt::format("{} -r 24 18 -s 4 -q --layers=all -o {} {}", box_scene,
                                    folder.file("a.exr"), options))
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

TEST_CASE("shapes of one name are one thing in a matte") {
  Film film(1, 1, {0, 0, 1, 1}, {{Layer::object_matte}});
  for (const std::uint32_t id : {1u, 2u, 3u, 3u}) add_sample(film, 0, 0, id, {{}, {record_id(id)}});
  const SceneNames names{{"leaf", "bark", "leaf"}, {}, {}, {}};
  const LayeredImage image = layered_picture(film, names);
  std::vector<float> values(image.channels.size());
  image.fill_row(0, values);
  CHECK(image.channels[3].name == "CryptoObject00.R");
  CHECK(std::bit_cast<std::uint32_t>(values[3]) == cryptomatte_id("leaf"));
  CHECK(values[4] == 0.75f);
  CHECK(std::bit_cast<std::uint32_t>(values[5]) == cryptomatte_id("bark"));
  CHECK(values[6] == 0.25f);
  CHECK(values[7] == 0);
}

TEST_CASE("a picture with mattes and ids has the names of what they stand for") {
  const TemporaryFolder folder;
  const std::string picture = folder.file("a.exr");
  REQUIRE(run_program(fmt::format("{} -r 8 6 -s 1 -q --layers=cryptomatte,ids -o {}", box_scene, picture))
              .exit_code == 0);
  const ImageMetadata stored = read_layers(picture).metadata;
  const std::map<std::string, std::string> metadata(stored.begin(), stored.end());
  for (const char* const kind : {"3ae39a5", "be359d6", "f42029d"})
    CHECK(metadata.contains(fmt::format("cryptomatte/{}/manifest", kind)));
  CHECK(metadata.at("cryptomatte/3ae39a5/name") == "CryptoObject");
  CHECK(metadata.contains("twinray:object_id"));
  CHECK(metadata.contains("twinray:material_id"));
}

TEST_CASE("an EXR is packed as asked for, but mattes never with a loss") {
  const TemporaryFolder folder;
  const auto compression = [&](const std::string& options) {
    const std::string picture = folder.file("a.exr");
    REQUIRE(run_program(fmt::format("{} -r 8 6 -s 1 -q {} -o {}", box_scene, options, picture)).exit_code ==
            0);
    const std::string bytes = read_text(picture);
    // Name, type, one byte, and that: the number of the kind.
    const std::string attribute = std::string("compression\0compression\0\1\0\0\0", 28);
    const std::size_t at = bytes.find(attribute);
    REQUIRE(at != bytes.npos);
    return int(bytes[at + attribute.size()]);
  };
  constexpr int zip = 3, dwab = 9;  // ImfCompression.h
  CHECK(compression("") == zip);
  CHECK(compression("--exr-compression=dwab") == dwab);
  CHECK(message_of({"--layers=cryptomatte", "--exr-compression=dwab", "-o", "a.exr"}) ==
        "--exr-compression: dwab changes numbers, and with them the ids of cryptomatte; zip does not");
  for (const char* layer : {"position", "normal", "geometric-normal", "variance"})
    CHECK(message_of({std::string("--layers=") + layer, "--exr-compression=dwab", "-o", "a.exr"}) ==
          fmt::format("--exr-compression: dwab changes numbers, and with them the layer {}; zip does not",
                      layer));
  CHECK(compression("--exr-compression=dwab --layers=albedo,depth,uv,ids,samples,alpha,light") == dwab);
}

TEST_CASE("names of ids are UTF-8, one a line, whatever bytes they have in the scene") {
  const FilmContents contents{{Layer::ids}, {0, 0}};
  SceneNames names;
  names.objects = {"w\xfcrfel", "a\nb\r\nc", "\xc3\xa4"};
  names.materials = {"plain"};
  const auto stored = layer_metadata(contents, names);
  CHECK(value_of(stored, "twinray:object_id") == "w\xc3\xbcrfel\na b  c\n\xc3\xa4");
  CHECK(value_of(stored, "twinray:material_id") == "plain");
}

TEST_CASE("a picture too bright for a packing with loss is packed without, and said to be") {
  const TemporaryFolder folder;
  write_exr(folder.file("sky.exr"), Image(2, 1, {70000, 1, 1}));
  const auto render = [&](const std::string& name, const std::string& options) {
    const ProcessResult done =
        run_program(fmt::format("{} -r 8 6 -s 1 -q -e {} {} -o {}", TWINRAY_SOURCE_DIR "/scenes/blocks.obj",
                                folder.file("sky.exr"), options, folder.file(name)));
    CHECK(done.exit_code == 0);
    return done.err;
  };
  CHECK(render("a.exr", "").empty());
  CHECK(contains(render("b.exr", "--exr-compression=dwab"), "dwab holds radiance up to 65504"));
  CHECK(read_image(folder.file("a.exr")).pixels == read_image(folder.file("b.exr")).pixels);
}

TEST_CASE("a part of the frame with layers is that part of the whole") {
  const FilmContents contents{{Layer::alpha, Layer::depth}, {0, 2}};
  Film whole(6, 4, {0, 0, 6, 4}, contents), part(6, 4, {2, 1, 5, 3}, contents);
  for (Film* const film : {&whole, &part})
    for (int y = film->window().y0; y < film->window().y1; ++y)
      for (int x = film->window().x0; x < film->window().x1; ++x)
        add_sample(*film, x, y, 0,
                   {{float(x), float(y), 0},
                    {{1, 0, 0}, {float(10 * y + x), 0, 0}},
                    {},
                    {{float(x), 0, 0}, {0, float(y), 0}}});
  const SceneNames names{{}, {}, {}, {"key", "fill"}};
  const auto row = [&](const Film& film, int y) {
    const LayeredImage image = layered_picture(film, names);
    std::vector<float> values(std::size_t(image.width) * image.channels.size());
    image.fill_row(y, values);
    return values;
  };
  CHECK(layered_picture(part, names).channels[8].name == "light_fill.R");
  CHECK(row(part, 1) == std::vector<float>{2, 2, 0, 1, 22, 2, 0, 0, 0, 2, 0,  //
                                           3, 2, 0, 1, 23, 3, 0, 0, 0, 2, 0,  //
                                           4, 2, 0, 1, 24, 4, 0, 0, 0, 2, 0});
  CHECK(row(whole, 3)[5 * 11 + 4] == 35);
}

}  // namespace twinray::test
