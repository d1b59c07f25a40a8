// SPDX-License-Identifier: Apache-2.0
#include "io/picture/tiled_texture.h"

#include <fmt/format.h>

#include <filesystem>

#include "core/error.h"
#include "io/picture/texture_file.h"
#include "io/picture/texture_store.h"
#include "tests/support/catch.h"
#include "tests/support/random.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {
namespace {

namespace fs = std::filesystem;

void write_noise(const std::string& path, int width, int height, int seed) {
  ByteImage image{width, height, {}};
  Random random{std::uint64_t(seed)};
  for (int i = 0; i < 3 * width * height; ++i) image.bytes.push_back(std::uint8_t(256 * random.unit()));
  write_png(path, image);
}

bool is_same(const MipMap& a, const MipMap& b) {
  if (a.levels() != b.levels()) return false;
  for (int level = 0; level < a.levels(); ++level)
    if (a.image(level).pixels != b.image(level).pixels) return false;
  return true;
}

constexpr PictureMeaning color, data{PictureRole::data}, number{PictureRole::data, PictureChannels::number};

void make_older(const std::string& path, int seconds) {
  fs::last_write_time(path, fs::last_write_time(path) - std::chrono::seconds(seconds));
}

}  // namespace

TEST_CASE("a converted picture has all texels of all levels, for every meaning, in memory and in tiles") {
  const TemporaryFolder folder;
  const std::string picture = folder.file("a.png");
  write_noise(picture, 300, 130, 1);
  for (const PictureMeaning& meaning : {color, data, number}) {
    const std::shared_ptr<const MipMap> source = load_texture(picture, meaning).image;
    const ConvertedTexture made = convert_texture({picture, meaning});
    CHECK(made.path == tiled_name(picture, meaning));
    CHECK(made.is_new);
    CHECK(made.levels == 9);
    CHECK(is_same(read_whole(open_tiled(made.path)), *source));
    fs::rename(picture, folder.file("away.png"));  // So nothing else can be read.
    const LoadOptions bounded{.textures = std::make_shared<TextureStore>(0)};
    const LoadedTexture tiled = load_texture(picture, meaning, bounded),
                        whole = load_texture(picture, meaning);
    CHECK(tiled.warning.empty());
    CHECK(whole.warning.empty());
    CHECK_FALSE(tiled.image->is_in_memory());
    CHECK(is_same(*tiled.image, *source));
    CHECK(is_same(*whole.image, *source));
    CHECK(is_same(*load_texture(made.path, meaning).image, *source));  // Named itself.
    fs::rename(folder.file("away.png"), picture);
  }
  CHECK(folder.file_count() == 4);
}

TEST_CASE("a converted picture says whether its texels lie from 0 to 1") {
  const TemporaryFolder folder;
  for (const float most : {1.0f, 1.5f}) {
    Image image(200, 100, {0, 0.5f, 0.25f});
    image.at(150, 50).g = most;
    const std::string picture = folder.file("a.exr");
    write_exr(picture, image);
    const std::string tiled = convert_texture({picture, color}).path;
    CHECK(open_tiled(tiled).is_within_unit == (most == 1));
    const LoadOptions bounded{.textures = std::make_shared<TextureStore>(0)};
    const auto in_tiles = load_texture(tiled, color, bounded).image;
    CHECK_FALSE(in_tiles->is_in_memory());
    CHECK(in_tiles->is_within_unit() == (most == 1));
    CHECK(load_texture(tiled, color).image->is_within_unit() == (most == 1));
    fs::remove(tiled);
  }
}

TEST_CASE("a conversion is done once, and again when the picture is newer") {
  const TemporaryFolder folder;
  const std::string picture = folder.file("a.png");
  write_noise(picture, 70, 90, 1);
  const std::string tiled = convert_texture({picture, color}).path;
  const std::string bytes = read_text(tiled);
  CHECK_FALSE(convert_texture({picture, color}).is_new);
  fs::remove(tiled);
  convert_texture({picture, color});
  CHECK(read_text(tiled) == bytes);  // The same picture, the same bytes.
  write_noise(picture, 70, 90, 2);
  make_older(tiled, 10);
  const std::shared_ptr<const MipMap> now = load_texture(picture, color).image;
  CHECK_FALSE(is_same(*now, read_whole(open_tiled(tiled))));  // The old tiles are not taken.
  CHECK(convert_texture({picture, color}).is_new);
  CHECK(is_same(*now, read_whole(open_tiled(tiled))));
}

TEST_CASE("tiles that are cut off, foreign or broken are refused, and the picture is read in their place") {
  const TemporaryFolder folder;
  const std::string picture = folder.file("a.png");
  write_noise(picture, 300, 200, 3);
  const std::shared_ptr<const MipMap> source = load_texture(picture, color).image;
  const std::string tiled = convert_texture({picture, color}).path, good = read_text(tiled);
  const auto check_refused = [&](const std::string& bytes) {
    CAPTURE(bytes.size());
    write_text(tiled, bytes);
    CHECK_THROWS_AS(open_tiled(tiled), Error);
    const LoadedTexture loaded = load_texture(picture, color);
    CHECK(loaded.warning.starts_with(tiled + ": "));
    CHECK(loaded.warning.ends_with(fmt::format("; {} is read in its place", picture)));
    CHECK(is_same(*loaded.image, *source));
    CHECK(load_texture(tiled, color).warning.ends_with("; it is shown magenta"));
  };
  for (const std::size_t size :
       {std::size_t(0), std::size_t(3), std::size_t(200), good.size() / 2, good.size() - 1})
    check_refused(good.substr(0, size));
  check_refused("no picture at all");
  // A size that the file does not have room for.
  const std::size_t window = good.find("dataWindow");
  REQUIRE(window != good.npos);
  std::string hostile = good;
  hostile[window + 11 + 6 + 4 + 9] = 0x1f;  // The third byte of the last column, and of the last row.
  hostile[window + 11 + 6 + 4 + 13] = 0x1f;
  check_refused(hostile);
  // Levels of another filter.
  std::string foreign = good;
  foreign.replace(foreign.find("box, version 1"), 14, "box, version 9");
  check_refused(foreign);
  // Without a word on its range.
  std::string silent = good;
  silent.replace(silent.find("within [0, 1]"), 13, "wherever they");
  check_refused(silent);
  // Not in tiles.
  write_exr(folder.file("b.exr"), Image(300, 200));
  check_refused(read_text(folder.file("b.exr")));
  CHECK(convert_texture({picture, color}).is_new);  // What is broken is written anew.
  CHECK(read_text(tiled) == good);
}

TEST_CASE("what cannot be converted is an error that says why") {
  const TemporaryFolder folder;
  const std::string none = folder.file("none.png");
  CHECK_THROWS_WITH(convert_texture({none, color}), none + ": there is no such file");
  CHECK(folder.file_count() == 0);
  write_noise(folder.file("a.png"), 80, 80, 1);
  const std::string tiled = convert_texture({folder.file("a.png"), color}).path;
  CHECK(load_texture(tiled, number).warning ==
        tiled +
            ": it holds colours, and a number is wanted; --convert-textures writes those; it is shown "
            "magenta");
}

}  // namespace twinray::test
