// SPDX-License-Identifier: Apache-2.0
// twinray verify: whether pictures are what their metadata say.
#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "cli/input_files.h"
#include "cli/shell_text.h"
#include "cli/verify/tile_check.h"
#include "io/picture/image_file.h"
#include "io/picture/png.h"
#include "tests/support/catch.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/text.h"

namespace twinray::test {
namespace {

namespace fs = std::filesystem;

const std::string scenes = TWINRAY_SOURCE_DIR "/scenes/";

std::string file_in(const TemporaryFolder& folder, const std::string& name) {
  return quoted(folder.file(name));
}

/// Renders a picture of 48 x 36 pixels: 9 tiles.
void render(const std::string& scene, const std::string& words) {
  const ProcessResult result = run_program(fmt::format("render {} -r 48 36 -q {}", quoted(scene), words));
  REQUIRE(result.err == "");
  REQUIRE(result.exit_code == 0);
}

ProcessResult verify(const std::string& words) { return run_program("verify " + words); }

std::string error_of(const std::string& words) {
  const ProcessResult result = verify(words);
  CHECK(result.exit_code == 1);
  return result.err;
}

}  // namespace

TEST_CASE("pictures are what their metadata say, in every format that keeps bits") {
  const TemporaryFolder folder;
  for (const std::string words :
       {"-o a.png", "-o b.exr --layers=all", "-o c.png --tone=agx --exposure=1", "-o d.exr --crop 7 3 30 20",
        "-o l.exr --overscan=2", "-o e.png -a 2 0.05 --seed 9", "-o f.exr --denoise=own",
        "-o g.exr --layers=light-groups --denoise=own --denoise-light-groups",
        "-o h.png --integrator=normals", "-o i.exr --integrator=cost", "-o j.png --noise-target=10 -s 64",
        "-o k.png --accel=bvh --bvh-width=2"}) {
    CAPTURE(words);
    const std::string name = words.substr(3, 5);
    render(scenes + "box.dae", "-s 4 -o " + file_in(folder, name) + words.substr(8));
    const ProcessResult result = verify(file_in(folder, name) + " --tiles=4 --seed=1");
    CHECK(result.err == "");
    CHECK(result.exit_code == 0);
    CHECK(contains(result.out, "Same bits      4 of 4 tiles"));
    CHECK(contains(result.out, "those without noise are not compared") == contains(words, "--denoise=own"));
  }
}

TEST_CASE("what time or noise has ended is the beginning of a picture of more samples") {
  const TemporaryFolder folder;
  const auto check = [&](const std::string& scene, const std::string& words, const std::string& said) {
    const std::string picture = file_in(folder, "a.exr");
    const ProcessResult rendered =
        run_program(fmt::format("render {} -r 48 36 -q {} -o {}", quoted(scenes + scene), words, picture));
    REQUIRE(rendered.exit_code == 0);
    const ProcessResult result = verify(picture + " --seed=1");
    INFO(words << "\n" << result.out << result.err);
    CHECK(result.exit_code == 0);
    CHECK(contains(result.out, said));
    CHECK(contains(result.out, "Same bits      9 of 9 tiles"));
  };
  check("box.dae", "--until=2020-01-01T00:00", " 1 samples a pixel");
  check("box.dae", "--until=2020-01-01T00:00 -a 4 0.1", " 1 samples a pixel");
  check("still-life.pbrt", "--noise-target=0.9", " 16 samples a pixel");
}

TEST_CASE("the picture of CS184's program is made again by its options") {
  const TemporaryFolder folder;
  const ProcessResult made = run_program(fmt::format("--cs184 -r 48 36 -s 4 -l 2 -m 2 -f {} {}",
                                                     file_in(folder, "a.png"), quoted(scenes + "box.dae")));
  REQUIRE(made.exit_code == 0);
  CHECK(contains(verify(file_in(folder, "a.png")).out, "Same bits      9 of 9 tiles"));
  const std::string by_brute_force = verify(file_in(folder, "a.png") + " --accel=brute-force").out;
  CHECK(contains(by_brute_force, "by engine brute-force"));
  CHECK(contains(by_brute_force, "Same bits      9 of 9 tiles"));
}

TEST_CASE("a merged picture is verified as that of one render") {
  const TemporaryFolder folder;
  for (const std::string part : {"0:3", "3:8"})
    render(scenes + "box.dae", fmt::format("--sample-range={} --of=8 -o {}", part,
                                           file_in(folder, std::string(1, part[0]) + ".film")));
  REQUIRE(run_program(fmt::format("merge -q {} {} -o {}", file_in(folder, "0.film"),
                                  file_in(folder, "3.film"), file_in(folder, "a.png")))
              .exit_code == 0);
  CHECK(contains(verify(file_in(folder, "a.png")).out, "Same bits      9 of 9 tiles"));
}

TEST_CASE("one pixel that was changed is found, and where it is") {
  const TemporaryFolder folder;
  render(scenes + "box.dae", "-s 4 -o " + file_in(folder, "a.exr"));
  StoredLayers picture = read_layers(folder.file("a.exr"));
  float& changed = picture.values[(20 * 48 + 33) * 3 + 1];
  changed = std::nextafter(changed, 9.0f);
  const auto fill_row = [&](int y, std::span<float> values) {
    std::copy_n(picture.values.begin() + y * 48 * 3, values.size(), values.begin());
  };
  write_exr(folder.file("b.exr"), LayeredImage{48, 36, picture.channels, fill_row}, picture.metadata);
  const ProcessResult result = verify(file_in(folder, "b.exr"));
  CHECK(result.exit_code == 1);
  CHECK(contains(result.err, "tile at 32 16: 1 pixels differ, the first at 33 20: G is "));
  CHECK(contains(result.out, "Same bits      8 of 9 tiles"));
}

TEST_CASE("what a picture says beside its command must be what that asks for") {
  const TemporaryFolder folder;
  const auto verify_with = [&](const std::string& words, const char* name, const std::string& value) {
    render(scenes + "box.dae", "-s 2 --seed=7 --crop 0 0 16 16 -o " + file_in(folder, "a.exr") + words);
    StoredLayers picture = read_layers(folder.file("a.exr"));
    const std::size_t channels = picture.channels.size();
    const auto fill_row = [&](int y, std::span<float> values) {
      std::copy_n(picture.values.begin() + std::ptrdiff_t(std::size_t(y) * 16 * channels), values.size(),
                  values.begin());
    };
    if (value.empty())
      std::erase_if(picture.metadata, [&](const auto& entry) { return entry.first == name; });
    else
      set_value(picture.metadata, name, value);
    write_exr(folder.file("b.exr"), LayeredImage{16, 16, picture.channels, fill_row}, picture.metadata,
              picture.frame);
    return verify(file_in(folder, "b.exr"));
  };
  const auto refused = [&](const std::string& words, const char* name, const std::string& value) {
    const ProcessResult result = verify_with(words, name, value);
    CHECK(result.exit_code == 1);
    const std::size_t begin = result.err.find("b.exr: ");
    return begin == std::string::npos ? result.err : result.err.substr(begin);
  };
  CHECK(verify_with(" --clamp=2", "twinray:seed", "7").exit_code == 0);
  CHECK(refused("", "twinray:seed", "8") == "b.exr: its twinray:seed is 8, and its command asks for 7\n");
  CHECK(refused("", "twinray:seed", "") == "b.exr: its twinray:seed is none, and its command asks for 7\n");
  CHECK(refused("", "twinray:filter", "box:0.5") ==
        "b.exr: its twinray:filter is box:0.5, and its command asks for blackman-harris:1.5\n");
  CHECK(contains(refused("", "twinray:scene", "other.dae"), "its twinray:scene is other.dae, and its "));
  CHECK(refused(" --clamp=2", "twinray:biased_by", "") ==
        "b.exr: its twinray:biased_by is none, and its command asks for clamp 2\n");
  CHECK(refused("", "twinray:biased_by", "clamp 2") ==
        "b.exr: its twinray:biased_by is clamp 2, and its command asks for none\n");
  CHECK(refused(" --accel=brute-force", "twinray:engine", "bvh") ==
        "b.exr: its twinray:engine is bvh, and its command asks for brute-force\n");
  CHECK(verify_with(" --accel=bvh", "twinray:engine", "brute-force, bvh").exit_code == 0);  // Merged.
  const ProcessResult doubtful = verify_with("", "twinray:engine", "brute-force");
  CHECK(doubtful.exit_code == 0);
  CHECK(contains(doubtful.err, "b.exr: its twinray:engine is brute-force, and --accel=auto chooses "));
}

TEST_CASE("verify takes the engines that render one picture alone") {
  const ProcessResult result = verify("a.png --accel=check");
  CHECK(result.exit_code == 2);
  CHECK(contains(result.err, "--accel: there is no \"check\"; valid are auto, "));
}

TEST_CASE("a picture of another triangle test is made again by its own engine") {
  const TemporaryFolder folder;
  const std::string own_test = "-s 4 --triangle-test=moller-trumbore -o ", picture = file_in(folder, "a.exr");
  render(scenes + "box.dae", own_test + picture + " --accel=bvh");
  const ProcessResult own = verify(picture + " --tiles=4 --seed=1");
  CHECK(own.err == "");
  CHECK(contains(own.out, "Same bits      4 of 4 tiles"));
  // Where it had no effect it has none with another engine.
  CHECK(run_program(fmt::format("render {} -r 48 36 -q {} --accel=brute-force", quoted(scenes + "box.dae"),
                                own_test + picture))
            .exit_code == 0);
  CHECK(contains(verify(picture + " --tiles=4 --seed=1 --accel=bvh").out, "Same bits      4 of 4 tiles"));
}

TEST_CASE("a channel that was taken away is found, and a place that is another") {
  const TemporaryFolder folder;
  render(scenes + "box.dae", "-s 4 --crop 7 3 30 20 -o " + file_in(folder, "a.exr"));
  const StoredLayers picture = read_layers(folder.file("a.exr"));
  const auto write_with = [&](std::size_t channels, const ImageFrame& frame) {
    const auto fill_row = [&](int y, std::span<float> values) {
      for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = picture.values[(std::size_t(y) * 30 + i / channels) * 3 + i % channels];
    };
    const std::vector<PictureChannel> kept(picture.channels.begin(),
                                           picture.channels.begin() + std::ptrdiff_t(channels));
    write_exr(folder.file("b.exr"), LayeredImage{30, 20, kept, fill_row}, picture.metadata, frame);
  };
  write_with(3, picture.frame);
  CHECK(verify(file_in(folder, "b.exr")).exit_code == 0);
  write_with(2, picture.frame);
  CHECK(contains(error_of(file_in(folder, "b.exr")), ": B is absent there, and "));
  ImageFrame moved = picture.frame;
  ++moved.x;
  write_with(3, moved);
  CHECK(contains(error_of(file_in(folder, "b.exr")),
                 "it lies at 8 3 of its frame, and its command asks for 7 3"));
}

TEST_CASE("a channel that is added or taken away is a difference, even where it is 0 all over") {
  const StoredLayers one{1, 1, {{"R"}}, {0}, {}, {}}, two{1, 1, {{"R"}, {"Z"}}, {0, 0}, {}, {}};
  CHECK_FALSE(differences(two, two, {0, 0, 1, 1}, false));
  const auto added = differences(two, one, {0, 0, 1, 1}, false);
  REQUIRE(added);
  CHECK(added->channel == "Z");
  CHECK(added->there == 0);
  CHECK_FALSE(added->here);
  const auto removed = differences(one, two, {0, 0, 1, 1}, false);
  REQUIRE(removed);
  CHECK(removed->channel == "Z");
  CHECK_FALSE(removed->there);
  CHECK(removed->here == 0);
}

TEST_CASE("an alpha that was added to a picture of 8 bits is found") {
  const TemporaryFolder folder;
  render(scenes + "box.dae", "-s 4 -o " + file_in(folder, "a.png"));
  const std::string stored = read_text(folder.file("a.png"));
  const Image image = read_image(folder.file("a.png"), {.role = PictureRole::data});
  const auto rewritten_with = [&](std::uint8_t alpha) {
    AlphaImage edited{image.width, image.height, {}};
    const auto byte = [](float value) { return std::uint8_t(std::lround(255 * value)); };
    for (const Rgb& p : image.pixels)
      edited.bytes.insert(edited.bytes.end(), {byte(p.r), byte(p.g), byte(p.b), 255});
    edited.bytes[(20 * 48 + 33) * 4 + 3] = alpha;
    const std::vector<unsigned char> bytes = encode_png(edited);
    const std::string png(bytes.begin(), bytes.end());
    constexpr std::size_t header = 33;  // With the signature; what else stands before the pixels says more.
    write_text(folder.file("b.png"), png.substr(0, header) +
                                         stored.substr(header, stored.find("IDAT") - 4 - header) +
                                         png.substr(png.find("IDAT") - 4));
    return verify(file_in(folder, "b.png"));
  };
  CHECK(rewritten_with(255).exit_code == 0);
  const ProcessResult result = rewritten_with(51);
  CHECK(result.exit_code == 1);
  CHECK(contains(result.err, "tile at 32 16: 1 pixels differ, the first at 33 20: A is 0.2"));
}

TEST_CASE("another version is warned of, and another size is refused") {
  const TemporaryFolder folder;
  render(scenes + "box.dae", "-s 4 -o " + file_in(folder, "a.exr"));
  StoredLayers picture = read_layers(folder.file("a.exr"));
  set_value(picture.metadata, "Software", "twinray 0.0.9");
  const auto write_rows = [&](const std::string& name, int rows) {
    const auto fill_row = [&](int y, std::span<float> values) {
      std::copy_n(picture.values.begin() + y * 48 * 3, values.size(), values.begin());
    };
    write_exr(folder.file(name), LayeredImage{48, rows, picture.channels, fill_row}, picture.metadata);
  };
  write_rows("b.exr", 36);
  const ProcessResult result = verify(file_in(folder, "b.exr"));
  CHECK(result.exit_code == 0);
  CHECK(contains(result.err, "b.exr: it was made by twinray 0.0.9, and this is twinray "));
  write_rows("c.exr", 30);
  CHECK(contains(error_of(file_in(folder, "c.exr")),
                 "it has 48 x 30 pixels, and its command asks for 48 x 36"));
}

TEST_CASE("a scene that has changed since is named") {
  const TemporaryFolder folder;
  fs::copy_file(scenes + "box.dae", folder.file("box.dae"));
  render(folder.file("box.dae"), "-s 4 -o " + file_in(folder, "a.png"));
  write_text(folder.file("box.dae"), read_text(folder.file("box.dae")) + "\n");
  CHECK(contains(error_of(file_in(folder, "a.png")), "a.png: box.dae is another file here"));
  CHECK(contains(verify(file_in(folder, "a.png") + " --scene " + quoted(scenes + "box.dae")).out,
                 "Same bits      9 of 9 tiles"));
  write_text(folder.file("box.dae"), "no COLLADA any more");
  CHECK(contains(error_of(file_in(folder, "a.png")), "a.png: box.dae is another file here"));
  fs::remove(folder.file("box.dae"));
  CHECK(contains(error_of(file_in(folder, "a.png")), "box.dae"));
}

TEST_CASE("pictures of which nothing can be said are refused, each with the reason") {
  const TemporaryFolder folder;
  const auto refused = [&](const std::string& name) { return error_of(file_in(folder, name)); };
  write_png(folder.file("plain.png"), ByteImage{4, 3, std::vector<std::uint8_t>(36)});
  CHECK(contains(refused("plain.png"), "it does not say how it was made"));
  CHECK(contains(refused("missing.png"), "missing.png"));
  render(scenes + "box.dae", "-s 4 -o " + file_in(folder, "a.jpg"));
  CHECK(contains(refused("a.jpg"), "a JPEG keeps no bits"));
  render(scenes + "box.dae", "-s 4 --exr-compression=dwab -o " + file_in(folder, "a.exr"));
  CHECK(contains(refused("a.exr"), "dwab, keeps no bits"));
  render(scenes + "box.dae", "-s 4 --denoise=own -o " + file_in(folder, "d.png"));
  CHECK(contains(refused("d.png"), "denoised pixels depend on all others"));
  render(scenes + "box.dae", "-s 32 --allocation=error -o " + file_in(folder, "s.png"));
  CHECK(contains(refused("s.png"), "depends on the whole picture, by --allocation=error"));
  CHECK(contains(verify(file_in(folder, "d_noisy.png")).out, "Same bits      9 of 9 tiles"));
  render(scenes + "box.dae", "-s 4 -a 2 0.1 -o " + file_in(folder, "r.png"));
  CHECK(contains(refused("r_rate.png"), "it shows the sample rates of another picture"));
  render(scenes + "box.dae", "-s 4 --layers=light-groups -o " + file_in(folder, "g.exr"));
  REQUIRE(run_program(fmt::format("relight {} -o {}", file_in(folder, "g.exr"), file_in(folder, "h.exr")))
              .exit_code == 0);
  CHECK(contains(refused("h.exr"), "its lights were mixed anew by `twinray relight"));
  render(scenes + "box.dae", "--sample-range=0:3 --of=8 -o " + file_in(folder, "p.film"));
  REQUIRE(run_program(fmt::format("merge -q --allow-gaps {} -o {}", file_in(folder, "p.film"),
                                  file_in(folder, "p.png")))
              .exit_code == 0);
  CHECK(contains(refused("p.png"), "it was merged without samples 3:8 of 8"));
  REQUIRE(run_program(fmt::format("render {} -r 48 36 -s 4000000 -t 1 -q --time-limit=1 -o {}",
                                  quoted(scenes + "box.dae"), file_in(folder, "i.png")))
              .exit_code == 142);
  CHECK(contains(refused("i_partial.png"), "it is what an interrupted render left: "));
}

TEST_CASE("tiles are chosen by the seed, each once") {
  const PixelRect window{3, 5, 100, 70};
  const std::vector<PixelRect> all = chosen_tiles(window, 1000, 1);
  CHECK(all.size() == tile_grid(window, tile_size).count());
  std::size_t pixels = 0;
  for (const PixelRect& tile : all) pixels += std::size_t(tile.width()) * std::size_t(tile.height());
  CHECK(pixels == 97 * 65);
  CHECK(chosen_tiles(window, 5, 1) == chosen_tiles(window, 5, 1));
  CHECK(chosen_tiles(window, 5, 1) != chosen_tiles(window, 5, 2));
}

TEST_CASE("files are others where one has changed, is gone, or is new") {
  const InputFiles files{{"a.dae", "01"}, {"b.png", "02"}};
  CHECK(file_difference(files, files, "here") == "");
  CHECK(file_difference(files, {{"a.dae", "01"}, {"b.png", "03"}}, "here") == "b.png is another file here");
  CHECK(file_difference(files, {{"a.dae", "01"}}, "here") == "its scene reads b.png, which is not read here");
  CHECK(file_difference(files, {{"a.dae", "01"}, {"b.png", "02"}, {"b.tx", "04"}}, "there") ==
        "its scene does not read b.tx, which is read there");
}

TEST_CASE("words and files come back from a picture's metadata, whatever their signs") {
  const Words words{"a b.dae", "it's", "", "-o", "x\\y", "*", "plain"};
  CHECK(words_of(shell_text(words)) == words);
  const InputFiles files{{"a  b.dae", "0123"}, {"c.ply", "none"}, {"d\ne\\n\\\\.png", "45"}};
  CHECK(parse_input_text(input_text(files)) == files);
}

}  // namespace twinray::test
